/** Which calls must not be done any more, since what they are about has been replaced meanwhile. */

import type { Edit } from '../pkg/engine/shape_up.js';
import type { Call } from '../solver/remote.ts';
import type { Changes, Commands } from './interface.ts';

/** Calls with values of the vertices, or a buffer for them. */
const ABOUT_MESH: ReadonlySet<string> = new Set<keyof Commands | keyof Changes>([
  ...['drag', 'recycle', 'setBuildNumbers'],
] as const);
const EDITS: ReadonlySet<string> = new Set<keyof Changes>(['edit', 'editAndRun']);

/**
 * Returns how to answer a call that must not be done; undefined if it can be done. An edit is about the
 * model, which may have another mesh by now, unless it names vertices or faces.
 * @param meshes the number of the first mesh of the open model, and of its current one
 */
export function answerIfReplaced(
  { name, given, mesh = 0 }: Call,
  [first, now]: readonly [number, number],
): 'outdated' | 'refused' | undefined {
  const isEdit = EDITS.has(name);
  if (mesh === now || !(isEdit || ABOUT_MESH.has(name))) return undefined;
  if (mesh < first || !isEdit) return 'outdated';
  return namesElements(given[0] as Edit) ? 'refused' : undefined;
}

type Lists = Partial<Record<'vertices' | 'faces', { length: number } | null>>;

/** Whether an edit names vertices or faces by their indices. */
function namesElements(edit: Edit) {
  const [given] = Object.values(edit) as (Lists & { on?: Lists; set?: Lists })[];
  return [given, given.on, given.set].some(
    (lists) => lists?.vertices?.length || lists?.faces?.length,
  );
}
