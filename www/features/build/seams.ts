/** Edges of the model along which paper is cut, as pairs of vertices. */

import { cornersOf } from '../../store/selection.ts';
import type { Selection } from '../../store/state.ts';
import type { Connectivity } from '../../solver/types.ts';

export type Edge = [number, number];

/** The same for both orders of the ends. */
const keyOf = ([a, b]: Edge) => (a < b ? `${a}-${b}` : `${b}-${a}`);

/**
 * Returns the selected edges between faces: the others are cut anyway. If vertices are selected and no
 * edges, these are the edges between two of them.
 */
export function selectedEdges({ edges, vertices }: Selection, connectivity: Connectivity): Edge[] {
  if (edges.size + vertices.size === 0) return [];
  const ends = connectivity.edges;
  const isSelected = (k: number) =>
    edges.size > 0 ? edges.has(k) : vertices.has(ends[2 * k]) && vertices.has(ends[2 * k + 1]);
  const found = new Map<string, { edge: Edge; faces: number }>();
  for (let k = 0; 2 * k < ends.length; k++) {
    const edge: Edge = [ends[2 * k], ends[2 * k + 1]];
    if (isSelected(k)) found.set(keyOf(edge), { edge, faces: 0 });
  }
  for (let face = 0; found.size > 0 && face + 1 < connectivity.faceOffsets.length; face++) {
    const corners = cornersOf(connectivity, face);
    corners.forEach((corner, k) => {
      const side = found.get(keyOf([corner, corners[(k + 1) % corners.length]]));
      if (side) side.faces++;
    });
  }
  return [...found.values()].filter(({ faces }) => faces > 1).map(({ edge }) => edge);
}

/** Returns the edges of the first list that are not in the second one. */
export function without(edges: Edge[], others: Edge[]): Edge[] {
  const known = new Set(others.map(keyOf));
  return edges.filter((edge) => !known.has(keyOf(edge)));
}
