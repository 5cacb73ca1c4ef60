/** Worker side of experiments: runs the requested one in slices, alongside the solver. */

import { messageOf, type FromWorker, type Request, type NamedBytes } from '../solver/messages.ts';
import { ExperimentRun, type Solver } from '../pkg/engine/shape_up.js';
import { isTrap } from './wasm-errors.ts';

/** Duration of a slice between other messages, in milliseconds. */
const SLICE_MS = 30;

type Post = (message: FromWorker) => void;

/** The last run; kept for its table. */
let run: ExperimentRun | null = null;
let underWay = false;
let post: Post = () => {};
/** Called when the wasm instance has trapped. */
let died: (thrown: unknown) => void = () => {};

const yielding = new MessageChannel();
yielding.port1.onmessage = slice;

/**
 * Starts an experiment; a running one is dropped without a message.
 * @param solver with the current model
 */
export function runExperiment(
  { of, iterations }: Extract<Request, { type: 'runExperiment' }>,
  solver: Solver,
  tell: Post,
  onDeath: (thrown: unknown) => void,
) {
  const next = of ? runOn(of, iterations) : ExperimentRun.ofOpen(solver, iterations);
  run?.free();
  run = next;
  post = tell;
  died = onDeath;
  if (!underWay) yielding.port2.postMessage(null);
  underWay = true;
  return null;
}

/** @param of the scene first */
function runOn(
  { example, files: [scene, mesh] }: { example: string; files: NamedBytes[] },
  iterations: number,
) {
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

function end(ended: 'done' | 'cancelled' | 'failed', message: string = '') {
  underWay = false;
  post({ type: 'experiment', news: run?.news() ?? [], ended, message });
}
