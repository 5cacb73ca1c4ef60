/**
 * The second worker: a second instance of the engine for what takes long, so that iterations and
 * drags do not wait for it. It answers one call after another.
 */

import init from '../pkg/engine/shape_up.js';
import { messageOf } from '../solver/errors.ts';
import { answerTo, type Answer, type Call } from '../solver/remote.ts';
import { builds } from './jobs/build.ts';
import { curvature } from './jobs/curvature.ts';
import { copyOf, letGo, type Holder } from './jobs/model-copy.ts';
import type { Snapshot } from '../solver/types.ts';

const jobs = { ...builds, ...curvature };
export type Jobs = typeof jobs;

/** A call of the copy of a holder: of this model if one is named, else of that which it has. */
export type JobCall = Call & { holder?: Holder; model?: Snapshot };

/** What has the method that is called. */
const called = ({ name, holder, model }: JobCall) =>
  !holder ? jobs : name === 'free' ? { free: () => letGo(holder) } : copyOf(holder, model);

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
