/**
 * The worker's part of remedies: tries, beside whatever the solver does, which changes would lower the
 * worst distance, until all are tried, the time is over, or something else is asked.
 */

import { RemedyTrials } from '../pkg/solver/shape_up.js';
import { inTurns } from './trials.js';

/** How long it tries at most: whoever waits longer does not wait. */
const MOST_MS = 4000;

/** @typedef {import("../solver/messages.js").Remedy} Remedy */

/**
 * @param {import("../pkg/solver/shape_up.js").Solver} solver
 * @returns {Promise<Remedy[]>} those found until then, the greatest help first
 */
export async function findRemedies(solver) {
  const trials = new RemedyTrials(solver);
  await inTurns(trials, MOST_MS);
  const found = trials.found();
  trials.free();
  return found;
}
