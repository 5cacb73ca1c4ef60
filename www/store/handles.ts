/** The handles as the page shows them, and whether they can be dragged. */

import type { Handle, SceneDocument } from '../solver/types.ts';
import type { State } from './state.ts';

/** Why no drag begins where {@link areHandlesLocked}. */
export const HANDLES_LOCKED = 'Locked by the lesson: the handles stay as they are.';

/** Returns the handles, with the current targets of dragged ones. */
export function handlesNow({ document, dragged, moved }: Readonly<State>): Handle[] {
  const handles = document?.handles ?? [];
  if (!moved) return handles;
  const offsets = new Map(dragged.map((vertex, i) => [vertex, 3 * i]));
  return handles.map((handle) => {
    const at = offsets.get(handle.vertex);
    if (at === undefined) return handle;
    const [x, y, z] = moved.targets.subarray(at, at + 3);
    return { ...handle, target: [x, y, z] };
  });
}

/** Whether a lesson locks the handles. */
export const areHandlesLocked = (document: SceneDocument | null) =>
  document?.lesson?.lock.includes('handles') ?? false;

/** Names a handle that can be dragged, by its colour in the view; empty if there is none. */
export function draggableInWords(document: SceneDocument) {
  const { handles } = document;
  if (handles.length === 0 || areHandlesLocked(document)) return '';
  return handles.some(({ fixed }) => !fixed) ? 'a blue handle' : 'a handle';
}
