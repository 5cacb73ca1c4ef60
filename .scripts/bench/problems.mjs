// The measured problems, on meshes of any size.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { targetFolder } from '../project.mjs';

/** Folder for all output of the benchmark. */
export const benchFolder = join(targetFolder, 'bench');

/** A number from -1/2 to 1/2, determined by a grid point and a channel. */
const jitter = (i, j, channel) => ((i * 7919 + j * 104729 + channel * 1299709) % 1009) / 1009 - 0.5;

/** Returns a generator of numbers from -1/2 to 1/2, the same in every run. */
function random() {
  let state = 1n;
  return () => {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    return Number(state >> 11n) / 2 ** 53 - 0.5;
  };
}

/** Displaces a point of the unit square on a surface by a part of an edge, half of it in height. */
function displaced(part, surface) {
  return (side) => {
    const next = random();
    const edge = part / (side - 1);
    return (i, j) => {
      const [x, y, z] = surface(i / (side - 1), j / (side - 1));
      return [x + 2 * edge * next(), y + 2 * edge * next(), z + edge * next()];
    };
  };
}

/** By name: from the number of vertices per side to the point of a place in the grid. */
const surfaces = {
  /** A jittered, bumpy height field with edges of about 1. */
  bumps: (side) => (i, j) => {
    const shift = (channel) => 0.3 * jitter(i, j, channel);
    const wave = Math.sin((5 * i) / side) * Math.cos((4 * j) / side);
    return [i + shift(1), j + shift(2), 0.1 * side * wave + 0.3 * shift(3)];
  },
  /** A quarter of a torus, whose edge lines are nearly its principal circles. */
  'near a principal net': displaced(0.01, (x, y) => {
    const [along, around] = [0.9 * (x - 0.5), 1.1 * (y - 0.5)];
    const radius = 0.6 + 0.5 * Math.cos(around);
    return [radius * Math.sin(along), 0.5 * Math.sin(around), radius * Math.cos(along)];
  }),
  /** A surface to which no solution is near. */
  rough: displaced(0.15, (x, y) => [
    ...[x, y],
    0.1 * Math.sin(3 * x) * Math.cos(4 * y) + 0.05 * Math.sin(7 * x * y),
  ]),
};

const circles = { constraints: [{ kind: 'circle', on: 'faces' }] };
const circular = { ...circles, weights: { shape: 5, close: 10, smooth: 2 } };
const rigid = (on) => ({
  constraints: [{ kind: 'rigid', on }],
  weights: { shape: 1 },
  closeness: { to: 'none' },
});

/** Panels to be made exact, with the weights of the reference study. */
const exact = (surface, kind) => ({
  ...{ surface, kind },
  scene: {
    constraints: [{ kind, on: 'faces', require: 'exact' }],
    weights: { shape: 5, close: 10, smooth: 2 },
    closeness: { to: 'rest' },
    smoothness: { of: 'displacement', weighting: 'uniform' },
  },
});

/**
 * By name: the surface (bumps unless named), whether its quads are split into triangles, and the
 * scene, or instead of one the weights of a conformal `map`. `lifted`: six handles, of which the
 * middle one is lifted. `traced`: the energies of every iteration are recorded, natively as well
 * as on the page. `converges`: the energy has a minimum to compare with. That of A is zero: nothing
 * holds the boundary, so that smoothness contracts the mesh on its surface without end.
 */
export const problems = {
  A: { scene: { ...circular, closeness: { to: 'surface' } } },
  B: { scene: rigid('faces'), lifted: true, converges: true },
  C: { triangles: true, scene: rigid('rings'), lifted: true, converges: true },
  D: { triangles: true, map: 'inverse-area' },
  E: {
    scene: { ...circular, closeness: { to: 'surface', boundary: { corners: 40 } } },
    traced: true,
  },
  circles: { scene: { ...circles, weights: { shape: 5, close: 10 }, closeness: { to: 'rest' } } },
  planes: {
    scene: {
      constraints: [{ kind: 'plane', on: 'faces' }],
      weights: { shape: 1 },
      closeness: { to: 'none' },
    },
  },
  lscm: { triangles: true, map: 'lscm' },
  'circles near a net': exact('near a principal net', 'circle'),
  'planes near a net': exact('near a principal net', 'plane'),
  'rough circles': exact('rough', 'circle'),
  'rough planes': exact('rough', 'plane'),
};

/** Returns the text of an OBJ file of a square grid. */
function objText(rows, side, triangles) {
  const lines = rows.map((row) => `v ${row.join(' ')}`);
  for (let first = 1; first < side * (side - 1); first++) {
    if (first % side === 0) continue;
    const [a, b, c, d] = [first, first + 1, first + side + 1, first + side];
    if (triangles) lines.push(`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`);
    else lines.push(`f ${a} ${b} ${c} ${d}`);
  }
  return `${lines.join('\n')}\n`;
}

/** The diagonal of the bounding box. */
function sizeOf(rows) {
  const extents = [0, 1, 2].map((c) => {
    const values = rows.map((row) => row[c]).sort((a, b) => a - b);
    return values.at(-1) - values[0];
  });
  return Math.hypot(...extents);
}

/** The four corners, a vertex between, and last the middle, which is lifted. */
function handlesOf(rows, side) {
  const [last, half, third, quarter] = [side - 1, side >> 1, Math.floor(side / 3), side >> 2];
  const corners = [0, last].flatMap((j) => [0, last].map((i) => [i, j]));
  const places = [...corners, [third, quarter], [half, half]];
  const vertices = places.map(([i, j]) => j * side + i);
  const targets = vertices.map((vertex) => [...rows[vertex]]);
  targets.at(-1)[2] += 0.3 * side;
  return { vertices, targets, weight: 100 };
}

/**
 * Returns the problem on a mesh of about `size` vertices: `scene` and `mesh` are the texts of its
 * files at `sceneFile` and `meshFile`, `size` is about the diameter of the bounding sphere, `spare` are
 * vertices that are no handles.
 */
export function problemOf(name, size, solver = {}) {
  const { surface = 'bumps', scene, lifted, triangles, ...rest } = problems[name];
  const side = Math.max(6, Math.round(Math.sqrt(size)));
  const point = surfaces[surface](side);
  const rows = Array.from({ length: side * side }, (_, k) => point(k % side, Math.floor(k / side)));
  const file = `${triangles ? 'triangles' : surface}-${side * side}.obj`.replaceAll(' ', '-');
  const handles = lifted ? [handlesOf(rows, side)] : [];
  const document = {
    ...{ format: 'shape-up-scene', version: 1, mesh: { file }, ...scene, handles },
    // Hard constraints begin at the converged soft solution, other problems iterate on.
    solver: { ...(rest.kind ? {} : { tolerance: 0 }), ...solver },
  };
  const fifth = Math.floor(side / 5);
  const [sceneFile, meshFile] = ['problem.shapeup.json', file].map((own) => join(benchFolder, own));
  const problem = {
    ...{ ...rest, surface, sceneFile, meshFile, handles: handles[0] },
    ...{ scene: JSON.stringify(document), mesh: objText(rows, side, triangles) },
    spare: [1, 2, 3].map((k) => k * fifth * side + k * fifth + 1),
    vertices: side * side,
    size: sizeOf(rows),
  };
  mkdirSync(benchFolder, { recursive: true });
  writeFileSync(sceneFile, problem.scene);
  writeFileSync(meshFile, problem.mesh);
  return problem;
}
