/**
 * The second worker: a second instance of the engine for what takes long, so that iterations and
 * drags do not wait for it. It answers one call after another.
 */

import init from '../pkg/engine/shape_up.js';
import { messageOf } from '../solver/errors.ts';
import { answerTo, type Answer, type Call } from '../solver/remote.ts';
import { builds } from './jobs/build.ts';
import { curvature } from './jobs/curvature.ts';
import { copyOf, currentCopy } from './jobs/model-copy.ts';
import type { ModelCopy } from '../pkg/engine/shape_up.js';
import type { Snapshot } from '../solver/types.ts';

const jobs = { ...builds, ...curvature };
/** What a copy of the open model answers. */
export type OnCopy = Omit<ModelCopy, 'free'>;
export type Jobs = typeof jobs & OnCopy;

/** A call of a copy of this model, if it names one. */
export type JobCall = Call & { model?: Snapshot };

/** What has the method that is called. */
const called = ({ name, model }: JobCall) =>
  model ? copyOf(model) : name in jobs ? jobs : currentCopy();

/** The first message is the engine's module, compiled; the others are calls. */
onmessage = ({ data: module }: MessageEvent<WebAssembly.Module>) => {
  const ready = init({ module_or_path: module });
  onmessage = async ({ data: call }: MessageEvent<JobCall & { id: number }>) => {
    const refused = (thrown: unknown): Answer => ({
      id: call.id,
      refused: messageOf(thrown),
      isDead: true,
    });
    postMessage(await ready.then(() => answerTo(() => called(call), call), refused));
  };
};
