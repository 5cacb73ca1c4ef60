/** Trials alongside the solver, one at a time, until another one begins or the shape changes. */

import type { FromWorker } from '../solver/events.ts';

/** Duration of a slice between other messages, in milliseconds. */
const SLICE_MS = 12;

let turn = 0;

/** Stops the current trial. */
export function stopTrials() {
  turn += 1;
}

/**
 * Each slice is announced as work: one step of a trial may take seconds on a large mesh.
 * @param most time limit, in milliseconds
 * @returns whether it was completed
 */
export function runInSlices(
  trial: { advance: (milliseconds: number) => boolean },
  post: (message: FromWorker) => void,
  most: number = Infinity,
): Promise<boolean> {
  const mine = ++turn;
  const until = performance.now() + most;
  return new Promise((resolve, reject) => {
    const advance = () => {
      try {
        if (mine !== turn || performance.now() > until) return resolve(false);
        post({ type: 'working' });
        const hasMore = trial.advance(SLICE_MS);
        post({ type: 'pong' });
        if (hasMore) setTimeout(advance);
        else resolve(true);
      } catch (error) {
        reject(error);
      }
    };
    setTimeout(advance);
  });
}
