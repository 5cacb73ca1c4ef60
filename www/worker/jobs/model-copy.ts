/**
 * Copies of the open model in the second worker, which answer under their own names. Work in several
 * calls has a copy of its own until it is freed: a question of another holder, about the model as it is
 * by then, would replace it.
 */

import { ModelCopy } from '../../pkg/engine/shape_up.js';
import type { Snapshot } from '../../solver/types.ts';

/** Who has a copy: work in several calls, or questions, each of which is one call. */
export type Holder = 'trials' | 'variations' | 'questions';

interface Copy {
  model: Snapshot;
  copy: ModelCopy;
}

const copies: Map<Holder, Copy> = new Map();

const isOf = ({ model }: Copy, { text, generation }: Snapshot) =>
  // A new worker of the solver counts its generations anew.
  model.generation === generation && model.text === text;

/**
 * The copy of a holder, of this model if one is given. Those of the same model have the same one.
 * @throws without a model, if it has none
 */
export function copyOf(holder: Holder, model?: Snapshot): ModelCopy {
  const own = copies.get(holder);
  if (own && (!model || isOf(own, model))) return own.copy;
  if (!model) throw new Error('nothing has been begun');
  letGo(holder);
  let held = [...copies.values()].find((other) => isOf(other, model));
  if (!held) {
    // Memory has room for few copies.
    letGo('questions');
    const { text, generation } = model;
    held = {
      model,
      copy: new ModelCopy(text, generation, (told: string) => postMessage({ told })),
    };
  }
  copies.set(holder, held);
  return held.copy;
}

/** Frees the copy of a holder, unless others have it too. */
export function letGo(holder: Holder) {
  const own = copies.get(holder);
  copies.delete(holder);
  if (own && ![...copies.values()].includes(own)) own.copy.free();
}
