/**
 * The worker's part of remedies: tries, beside whatever the solver does, which changes would lower the
 * worst distance, until all are tried, the time is over, or something else is asked.
 */

import { RemedyTrials } from '../pkg/solver/shape_up.js';

/** How long it tries before other messages have their turn, in milliseconds. */
const SLICE_MS = 12;
/** How long it tries at most: whoever waits longer does not wait. */
const MOST_MS = 4000;

/** @typedef {import("../solver/messages.js").Remedy} Remedy */

let turn = 0;

/** Something else is asked. */
export function stopTrials() {
  turn += 1;
}

/**
 * @param {import("../pkg/solver/shape_up.js").Solver} solver
 * @returns {Promise<Remedy[]>} those found until then, the greatest help first
 */
export function findRemedies(solver) {
  const mine = ++turn;
  const until = performance.now() + MOST_MS;
  const trials = new RemedyTrials(solver);
  return new Promise((resolve, reject) => {
    const goOn = () => {
      try {
        const isOver = mine !== turn || performance.now() > until;
        if (!isOver && trials.advance(SLICE_MS)) return void setTimeout(goOn);
        resolve(trials.found());
        trials.free();
      } catch (error) {
        reject(error);
      }
    };
    setTimeout(goOn);
  });
}
