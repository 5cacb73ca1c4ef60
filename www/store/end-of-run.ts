/** The end of a run that is about to begin. */

import type { SolverClient } from '../solver/solver-client.ts';

/**
 * Waits for the end of the next run. To be called before what begins it: a short run may have ended
 * when its beginning is answered.
 * @param began whether a run that is under way counts
 * @returns `ended` resolves with whether it converged; `stop` waits no longer
 */
export function endOfRun(solver: Pick<SolverClient, 'on'>, began: boolean = false) {
  let stop = () => {};
  const ended = new Promise<boolean>((settle) => {
    const ends = [
      // A run that is refused ends where it would have begun.
      solver.on('trouble', () => (began = true)),
      solver.on('activity', ({ running, converged }) => {
        began ||= running;
        if (running || !began) return;
        stop();
        settle(converged);
      }),
    ];
    stop = () => ends.forEach((end) => end());
  });
  return { ended, stop: () => stop() };
}
