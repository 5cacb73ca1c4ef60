/**
 * Worker side of remedies: tries, alongside the solver, which changes would lower the worst
 * distance, until all are tried, time is up, or the trials are stopped.
 */

import { RemedyTrials } from '../pkg/engine/shape_up.js';
import { runInSlices } from './trials.js';

/** Time limit of the trials, in milliseconds. */
const MOST_MS = 4000;

/** @typedef {import("../solver/messages.js").Remedy} Remedy */

/**
 * @param {import("../pkg/engine/shape_up.js").Solver} solver
 * @param {(message: import("../solver/messages.js").FromWorker) => void} post
 * @returns {Promise<Remedy[]>} those found so far, most effective first
 */
export async function findRemedies(solver, post) {
  const trials = new RemedyTrials(solver);
  await runInSlices(trials, post, MOST_MS);
  const found = trials.found();
  trials.free();
  return found;
}
