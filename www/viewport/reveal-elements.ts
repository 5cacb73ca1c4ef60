/** Reveals listed elements: selects them and moves the camera to them. */

import { cornersOf, verticesOf } from '../store/selection.ts';
import type { AppContext } from '../app/context.ts';
import type { Connectivity } from '../solver/types.ts';

type Elements = {
  vertices: ArrayLike<number>;
  edges?: ArrayLike<number>;
  faces: ArrayLike<number>;
};

/** Rings of faces around the elements to include in the picture, for orientation. */
const RINGS = 2;

/** @param elements their vertices, edges and faces */
export function showElements(
  { actions, solver, viewport }: AppContext,
  { vertices, edges = [], faces }: Elements,
) {
  const { geometry } = solver;
  if (!geometry) return;
  const { connectivity } = geometry;
  const all = {
    vertices: Array.from(vertices),
    edges: Array.from(edges),
    faces: Array.from(faces),
  };
  actions.select(all);
  let around = new Set(verticesOf(all, connectivity));
  for (let ring = 0; ring < RINGS; ring++) around = withNeighbours(connectivity, around);
  if (around.size > 0) viewport.with((view) => view.fitVertices(Uint32Array.from(around)));
}

/** Returns the vertices together with those of all faces incident to them. */
function withNeighbours(connectivity: Connectivity, vertices: Set<number>) {
  const all = new Set(vertices);
  for (let face = 0; face + 1 < connectivity.faceOffsets.length; face++) {
    const own = cornersOf(connectivity, face);
    if (own.some((vertex) => vertices.has(vertex))) own.forEach((vertex) => all.add(vertex));
  }
  return all;
}
