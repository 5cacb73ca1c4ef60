// New panels along the lines of curvature of triangulated roofs, beside the quads of other libraries:
// how they lie, and how far they move to become circular.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { hillTriangles, vaultTriangles } from '../surfaces.mjs';
import { quadsOf } from './peers.mjs';
import { benchFolder, objText } from './problems.mjs';
import { repeated } from './statistics.mjs';

const surfaces = { vault: vaultTriangles, hills: hillTriangles };
/** What makes the quads: ours with each choice at the boundary, and other libraries. */
const WAYS = [
  { library: 'ours, boundary followed', boundary: 'follow' },
  { library: 'ours, boundary cut', boundary: 'cut' },
  { library: 'pynanoinstantmeshes' },
  { library: 'pyQuadriFlow' },
];
const PANELS = [500, 2000];

const [from, to] = ['triangles', 'quads'].map((name) => join(benchFolder, `${name}.obj`));

/** The cases: each surface with each number of panels. */
export const quadCases = ({ sizes = PANELS }) =>
  Object.keys(surfaces).flatMap((surface) => sizes.map((panels) => ({ surface, panels })));

/** The points and faces of an OBJ file, by the first letter of their lines. */
const rowsIn = (path, letter) =>
  readFileSync(path, 'utf8')
    .split('\n')
    .filter((line) => line.startsWith(`${letter} `))
    .map((line) => line.slice(2).trim().split(/\s+/).map(Number));

/** The mean length of the edges of a mesh, and the vertices inside where not four of them meet. */
function edgesIn(path) {
  const [points, faces] = [rowsIn(path, 'v'), rowsIn(path, 'f')];
  const sides = new Map();
  for (const face of faces)
    for (const [k, a] of face.entries()) {
      const ends = [a, face[(k + 1) % face.length]].sort((one, other) => one - other);
      const side = sides.get(ends.join()) ?? { ends, faces: 0 };
      sides.set(ends.join(), { ends, faces: side.faces + 1 });
    }
  const [degrees, outside] = [new Map(), new Set()];
  let sum = 0;
  for (const { ends, faces: count } of sides.values()) {
    const [a, b] = ends.map((v) => points[v - 1]);
    sum += Math.hypot(...a.map((x, i) => x - b[i]));
    for (const v of ends) {
      degrees.set(v, (degrees.get(v) ?? 0) + 1);
      if (count === 1) outside.add(v);
    }
  }
  const irregular = [...degrees].filter(([v, degree]) => degree !== 4 && !outside.has(v));
  return { edge: sum / sides.size, irregular: irregular.length };
}

/** Measures one way to make panels; moves are in mean edges of the panels. */
async function measuredWay({ library, boundary }, { points, faces }, panels, on, where) {
  const mesh = objText(points, faces);
  const row = { library, triangles: faces.length, seconds: {} };
  if (boundary) {
    writeFileSync(from, mesh);
    const task = { mesh, from, to, panels, boundary };
    for (const place of where)
      row.seconds[place] = (await repeated('seconds', () => on(place, 'remesh', task))).seconds;
  } else {
    const { failed, version, seconds } = quadsOf(library, { points, faces, panels }, to);
    if (failed) return { ...row, quads: { level: failed } };
    row.library = version;
    row.seconds.native = seconds;
  }
  const { moved, ...quads } = await on('native', 'circular', { meshFile: to });
  const { edge, irregular } = edgesIn(to);
  return { ...row, quads: { ...quads, irregular, mean: moved.mean / edge, max: moved.max / edge } };
}

/** Measures a case in all ways; others beside the first of ours. */
export async function measureQuads({ surface, panels }, on, where) {
  mkdirSync(benchFolder, { recursive: true });
  const rows = [];
  for (const way of WAYS) {
    const row = await measuredWay(way, surfaces[surface](), panels, on, where);
    const ratio = row.seconds.native?.median / rows[0]?.seconds.native.median;
    rows.push(way.boundary ? row : { ...row, ratio });
  }
  return rows;
}
