/** The selection: sets of vertices, edges and faces, and how clicks and regions change them. */

import { count } from '../ui/words.ts';
import { IS_MAC } from '../ui/keys.ts';
import type { Mode, Selection } from './state.ts';
import type { Geometry } from '../solver/solver-client.ts';
import type { Connectivity } from '../solver/types.ts';

export type Combine = 'replace' | 'add' | 'remove';

export const NOTHING: Selection = { vertices: new Set(), edges: new Set(), faces: new Set() };

/**
 * Rhino's rule: Shift adds, Ctrl removes; on a Mac Cmd, where Ctrl + click opens the menu.
 * @param adds whether a button does what Shift does, for fingers
 */
export function combineOf(
  event: { shiftKey: boolean; ctrlKey: boolean; metaKey: boolean },
  adds: boolean = false,
): Combine {
  if (event.metaKey || (event.ctrlKey && !IS_MAC)) return 'remove';
  return event.shiftKey || adds ? 'add' : 'replace';
}

/** @param mode kind of the `items` */
export function select(
  selection: Selection,
  mode: Mode,
  items: Iterable<number>,
  combine: Combine,
): Selection {
  if (combine === 'replace') return { ...NOTHING, [mode]: new Set(items) };
  const next = new Set(selection[mode]);
  for (const item of items) {
    if (combine === 'add') next.add(item);
    else next.delete(item);
  }
  return { ...selection, [mode]: next };
}

/** Smallest and largest radius of the brush, in CSS pixels. */
const BRUSH = [4, 120];

/** Returns the radius of the brush times a factor. */
export const resizedBrush = (radius: number, factor: number) =>
  Math.min(Math.max(radius * factor, BRUSH[0]), BRUSH[1]);

/** Number of selected elements. */
export function sizeOfSelection({ vertices, edges, faces }: Selection) {
  return vertices.size + edges.size + faces.size;
}

/** Returns the vertices, the ends of the edges and the corners of the faces, ascending. */
export function verticesOf(
  elements: Record<Mode, Iterable<number>>,
  connectivity: Connectivity,
): number[] {
  const { edges } = connectivity;
  const vertices = new Set(elements.vertices);
  for (const edge of elements.edges) vertices.add(edges[2 * edge]).add(edges[2 * edge + 1]);
  for (const face of elements.faces)
    for (const vertex of cornersOf(connectivity, face)) vertices.add(vertex);
  return [...vertices].sort((a, b) => a - b);
}

/**
 * Returns the elements that a mesh has: a list may be of one that was open before.
 * @param mesh null if there is none
 */
export function existing(
  { vertices, edges, faces }: Partial<Record<Mode, Iterable<number>>>,
  mesh: Pick<Geometry, 'connectivity' | 'positions'> | null,
): Record<Mode, number[]> {
  const below = (most: number, items: Iterable<number> = []) =>
    [...items].filter((item) => item < most);
  const { positions = [], connectivity } = mesh ?? {};
  return {
    vertices: below(positions.length / 3, vertices),
    edges: below((connectivity?.edges.length ?? 0) / 2, edges),
    faces: below((connectivity?.faceOffsets.length ?? 1) - 1, faces),
  };
}

/** Returns the corners of a face. */
export function cornersOf({ faceOffsets, faceIndices }: Connectivity, face: number) {
  return faceIndices.subarray(faceOffsets[face], faceOffsets[face + 1]);
}

/** Describes the selection; empty if nothing is selected. */
export function describe(selection: Selection) {
  const parts = [];
  if (selection.vertices.size > 0) parts.push(count(selection.vertices.size, 'vertex', 'vertices'));
  if (selection.edges.size > 0) parts.push(count(selection.edges.size, 'edge'));
  if (selection.faces.size > 0) parts.push(count(selection.faces.size, 'face'));
  return parts.join(', ');
}
