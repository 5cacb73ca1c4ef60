/** The copy of the open model in the second worker, which answers under its own names. */

import { ModelCopy } from '../../pkg/engine/shape_up.js';
import type { Snapshot } from '../../solver/types.ts';

let copy: ModelCopy | null = null;
/** What it is a copy of. */
let copied: Snapshot | null = null;

/** Opens the model, unless it is the one that is open. */
export function copyOf(model: Snapshot): ModelCopy {
  const { text, generation } = model;
  // A new worker of the solver counts its generations anew.
  if (copy && copied?.generation === generation && copied.text === text) return copy;
  copy?.free();
  // The constructor may throw.
  copy = copied = null;
  copy = new ModelCopy(text, generation, (told: string) => postMessage({ told }));
  copied = model;
  return copy;
}

/** The copy on which something was begun. */
export function currentCopy(): ModelCopy {
  if (!copy) throw new Error('nothing has been begun');
  return copy;
}
