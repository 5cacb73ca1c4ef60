/** Trials beside whatever the solver does, one at a time, until something else is asked. */

/** How long it tries before other messages have their turn, in milliseconds. */
const SLICE_MS = 12;

let turn = 0;

/** Something else is asked. */
export function stopTrials() {
  turn += 1;
}

/**
 * @param {{ advance: (milliseconds: number) => boolean }} trial
 * @param {number} [most] how long it tries at most, in milliseconds
 * @returns {Promise<boolean>} whether it came to its end
 */
export function inTurns(trial, most = Infinity) {
  const mine = ++turn;
  const until = performance.now() + most;
  return new Promise((resolve, reject) => {
    const goOn = () => {
      try {
        if (mine !== turn || performance.now() > until) resolve(false);
        else if (trial.advance(SLICE_MS)) setTimeout(goOn);
        else resolve(true);
      } catch (error) {
        reject(error);
      }
    };
    setTimeout(goOn);
  });
}
