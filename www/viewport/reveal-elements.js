/** Reveals listed elements: selects them and moves the camera to them. */

/** @typedef {{ vertices: ArrayLike<number>, edges?: ArrayLike<number>, faces: ArrayLike<number> }} Elements */

/** Rings of faces around the elements to include in the picture, for orientation. */
const RINGS = 2;

/**
 * @param {import("../app/context.js").AppContext} app
 * @param {Elements} elements their vertices, edges and faces
 */
export function showElements({ actions, solver, viewport }, { vertices, edges = [], faces }) {
  const { geometry } = solver;
  if (!geometry) return;
  const { connectivity } = geometry;
  const all = [vertices, edges, faces].map((elements) => Array.from(elements));
  actions.select({ vertices: all[0], edges: all[1], faces: all[2] });
  let around = new Set(Array.from(vertices));
  for (const edge of Array.from(edges)) {
    around.add(connectivity.edges[2 * edge]).add(connectivity.edges[2 * edge + 1]);
  }
  for (const face of Array.from(faces)) corners(connectivity, face).forEach((v) => around.add(v));
  for (let ring = 0; ring < RINGS; ring++) around = withNeighbours(connectivity, around);
  if (around.size > 0) viewport.with((view) => view.fitVertices(Uint32Array.from(around)));
}

/** @param {import("../solver/messages.js").Connectivity} connectivity @param {number} face */
const corners = ({ faceOffsets, faceIndices }, face) =>
  faceIndices.subarray(faceOffsets[face], faceOffsets[face + 1]);

/**
 * Returns the vertices together with those of all faces incident to them.
 * @param {import("../solver/messages.js").Connectivity} connectivity
 * @param {Set<number>} vertices
 */
function withNeighbours(connectivity, vertices) {
  const all = new Set(vertices);
  for (let face = 0; face + 1 < connectivity.faceOffsets.length; face++) {
    const own = corners(connectivity, face);
    if (own.some((vertex) => vertices.has(vertex))) own.forEach((vertex) => all.add(vertex));
  }
  return all;
}
