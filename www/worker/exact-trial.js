/**
 * The worker's part of being exact: tries, beside whatever the solver does, what it would cost, and keeps the
 * shape that was found for whoever wants it.
 */

import { ExactTrials } from '../pkg/solver/shape_up.js';
import { inTurns } from './trials.js';

/** @typedef {import("../pkg/solver/shape_up.js").Solver} Solver */

/** The last one that came to its end. @type {ExactTrials | null} */
let tried = null;

/**
 * @param {Solver} solver
 * @returns {Promise<import("../solver/messages.js").ExactOffer | null>} null where something came between, or
 *   nothing is asked within a distance
 */
export async function exactOffer(solver) {
  tried?.free();
  tried = null;
  const trial = new ExactTrials(solver);
  if (!(await inTurns(trial, Infinity))) {
    trial.free();
    return null;
  }
  tried = trial;
  return trial.offer();
}

/** Takes the shape that was tried. @param {Solver} solver @returns {boolean} whether it was of the current shape */
export function makeExact(solver) {
  return tried?.accept(solver) ?? false;
}
