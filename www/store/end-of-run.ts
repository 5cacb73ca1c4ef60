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
    stop = solver.on('activity', ({ running, converged }) => {
      began ||= running;
      if (running || !began) return;
      stop();
      settle(converged);
    });
  });
  return { ended, stop: () => stop() };
}
