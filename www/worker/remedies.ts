/**
 * Worker side of remedies: tries, alongside the solver, which changes would lower the worst
 * distance, until all are tried, time is up, or the trials are stopped.
 */

import { RemedyTrials, type Solver } from '../pkg/engine/shape_up.js';
import { runInSlices } from './trials.ts';
import type { FromWorker } from '../solver/events.ts';
import type { Remedy } from '../solver/types.ts';

/** Time limit of the trials, in milliseconds. */
const MOST_MS = 4000;

/** @returns those found so far, most effective first */
export async function findRemedies(
  solver: Solver,
  post: (message: FromWorker) => void,
): Promise<Remedy[]> {
  const trials = new RemedyTrials(solver);
  await runInSlices(trials, post, MOST_MS);
  const found = trials.found();
  trials.free();
  return found;
}
