/**
 * The second worker: a second instance of the engine for what takes long, so that iterations and
 * drags do not wait for it. It answers one call after another.
 */

import init from '../pkg/engine/shape_up.js';
import { messageOf } from '../solver/errors.ts';
import type { Call } from '../solver/remote.ts';
import { builds } from './jobs/build.ts';
import { curvature } from './jobs/curvature.ts';
import { onCopy } from './jobs/model-copy.ts';
import { isTrap } from './wasm-errors.ts';

const jobs = { ...builds, ...curvature, ...onCopy };
export type Jobs = typeof jobs;

/** The answer to a call; after a trap, this worker is of no use. */
export type JobAnswer =
  { id: number; value: unknown } | { id: number; refused: string; isDead: boolean };

const methods = jobs as unknown as Record<string, (...given: unknown[]) => unknown>;

/** Settled when the engine can be called. */
let ready: Promise<unknown>;

/** The first message is the engine's module, compiled; the others are calls. */
onmessage = ({ data: module }: MessageEvent<WebAssembly.Module>) => {
  ready = init({ module_or_path: module });
  onmessage = (event: MessageEvent<Call & { id: number }>) => answer(event.data);
};

async function answer({ id, name, given }: Call & { id: number }) {
  const post = (answer: JobAnswer) => postMessage(answer);
  let isReady = false;
  try {
    await ready;
    isReady = true;
    post({ id, value: methods[name](...given) });
  } catch (thrown) {
    post({ id, refused: messageOf(thrown), isDead: !isReady || isTrap(thrown) });
  }
}
