/** Worker side of experiments: runs the requested one in slices, alongside the solver. */

import { messageOf } from '../solver/messages.js';
import { ExperimentRun } from '../pkg/engine/shape_up.js';
import { isTrap } from './wasm-errors.js';

/** Duration of a slice between other messages, in milliseconds. */
const SLICE_MS = 30;

/** @typedef {(message: import("../solver/messages.js").FromWorker) => void} Post */

/** The last run; kept for its table. @type {ExperimentRun | null} */
let run = null;
let underWay = false;
/** @type {Post} */
let post = () => {};
/** Called when the wasm instance has trapped. @type {(thrown: unknown) => void} */
let died = () => {};

const yielding = new MessageChannel();
yielding.port1.onmessage = slice;

/**
 * Starts an experiment; a running one is dropped without a message.
 * @param {Extract<import("../solver/messages.js").Request, { type: "runExperiment" }>} asked
 * @param {import("../pkg/engine/shape_up.js").Solver} solver with the current model
 * @param {Post} tell
 * @param {(thrown: unknown) => void} onDeath
 */
export function runExperiment({ of, iterations }, solver, tell, onDeath) {
  const next = of ? runOn(of, iterations) : ExperimentRun.ofOpen(solver, iterations);
  run?.free();
  run = next;
  post = tell;
  died = onDeath;
  if (!underWay) yielding.port2.postMessage(null);
  underWay = true;
  return null;
}

/**
 * @param {{ example: string, files: import("../solver/messages.js").NamedBytes[] }} of the scene first
 * @param {number} iterations
 */
function runOn({ example, files: [scene, mesh] }, iterations) {
  const text = new TextDecoder().decode(scene.bytes);
  return new ExperimentRun(example, text, mesh.name, mesh.bytes, iterations);
}

/** Returns the declaration of the comparison on the current model. */
export const comparison = () => ExperimentRun.declared();

export function cancelExperiment() {
  if (underWay) end('cancelled');
}

/** Returns all samples of the last experiment as CSV. */
export function experimentCsv() {
  if (!run) throw new Error('no experiment has been run');
  return run.csv();
}

function slice() {
  if (!run || !underWay) return;
  try {
    const more = run.advance(SLICE_MS);
    if (!more) return end('done');
    post({ type: 'experiment', news: run.news(), ended: null, message: '' });
    yielding.port2.postMessage(null);
  } catch (thrown) {
    if (isTrap(thrown)) died(thrown);
    else end('failed', messageOf(thrown));
  }
}

/**
 * @param {"done" | "cancelled" | "failed"} ended
 * @param {string} [message]
 */
function end(ended, message = '') {
  underWay = false;
  post({ type: 'experiment', news: run?.news() ?? [], ended, message });
}
