/**
 * The second worker: a second instance of the engine for what takes long, so that iterations and
 * drags do not wait for it. It answers one call after another.
 */

import init from '../pkg/engine/shape_up.js';
import { messageOf } from '../solver/errors.ts';
import { answerTo, type Answer, type Call } from '../solver/remote.ts';
import { builds } from './jobs/build.ts';
import { curvature } from './jobs/curvature.ts';
import { onCopy } from './jobs/model-copy.ts';

const jobs = { ...builds, ...curvature, ...onCopy };
export type Jobs = typeof jobs;

/** The first message is the engine's module, compiled; the others are calls. */
onmessage = ({ data: module }: MessageEvent<WebAssembly.Module>) => {
  const ready = init({ module_or_path: module });
  onmessage = async ({ data: call }: MessageEvent<Call & { id: number }>) => {
    const refused = (thrown: unknown): Answer => ({
      id: call.id,
      refused: messageOf(thrown),
      isDead: true,
    });
    postMessage(await ready.then(() => answerTo(jobs, call), refused));
  };
};
