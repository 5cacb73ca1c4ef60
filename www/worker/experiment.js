/**
 * The worker's part of experiments: runs the one that was asked for in slices, beside whatever the
 * solver does, and tells what it measures.
 */

import { messageOf } from '../solver/messages.js';
import { ExperimentRun } from '../pkg/solver/shape_up.js';
import { isTrap } from './wasm-errors.js';

/** How long it iterates before other messages have their turn, in milliseconds. */
const SLICE_MS = 30;

/** @typedef {(message: import("../solver/messages.js").FromWorker) => void} Post */

/** The last one; it stays for its table. @type {ExperimentRun | null} */
let run = null;
let underWay = false;
/** @type {Post} */
let post = () => {};
/** Called when the wasm machine has trapped. @type {(thrown: unknown) => void} */
let died = () => {};

const yielding = new MessageChannel();
yielding.port1.onmessage = slice;

/**
 * Starts one; another that is under way ends without a word.
 * @param {Extract<import("../solver/messages.js").Request, { type: "runExperiment" }>} asked
 * @param {import("../pkg/solver/shape_up.js").Solver} solver with what is open
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

/** What the comparison on whatever is open declares. */
export const comparison = () => ExperimentRun.declared();

export function cancelExperiment() {
  if (underWay) end('cancelled');
}

/** Comma-separated values of everything that the last one has measured. */
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
