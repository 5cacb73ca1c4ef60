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

/** Displaces a point at random by up to a length, half of it in height. */
const displaced = ([x, y, z], length, next) => [
  x + 2 * length * next(),
  y + 2 * length * next(),
  z + length * next(),
];

/** By name: the point at a place of a grid with some vertices per side. */
const surfaces = {
  /** A jittered, bumpy height field with edges of about 1. */
  bumps(i, j, side) {
    const shift = (channel) => 0.3 * jitter(i, j, channel);
    const wave = Math.sin((5 * i) / side) * Math.cos((4 * j) / side);
    return [i + shift(1), j + shift(2), 0.1 * side * wave + 0.3 * shift(3)];
  },
  /** A quarter of a torus, whose edge lines are nearly its principal circles. */
  'near a principal net'(i, j, side, next) {
    const [along, around] = [0.9 * (i / (side - 1) - 0.5), 1.1 * (j / (side - 1) - 0.5)];
    const radius = 0.6 + 0.5 * Math.cos(around);
    const point = [radius * Math.sin(along), 0.5 * Math.sin(around), radius * Math.cos(along)];
    return displaced(point, 0.01 / (side - 1), next);
  },
  /** A surface to which no solution is near. */
  rough(i, j, side, next) {
    const [x, y] = [i / (side - 1), j / (side - 1)];
    const height = 0.1 * Math.sin(3 * x) * Math.cos(4 * y) + 0.05 * Math.sin(7 * x * y);
    return displaced([x, y, height], 0.15 / (side - 1), next);
  },
};

const circles = { constraints: [{ kind: 'circle', on: 'faces' }] };
const weights = { shape: 5, close: 10, smooth: 2 };
const free = { weights: { shape: 1 }, closeness: { to: 'none' } };
const rigid = (on) => ({ constraints: [{ kind: 'rigid', on }], ...free });

/** Panels to be made exact, with the weights of the reference study. */
const exact = (surface, kind) => ({
  ...{ surface, kind },
  scene: {
    constraints: [{ kind, on: 'faces', require: 'exact' }],
    weights,
    closeness: { to: 'rest' },
    smoothness: { of: 'displacement', weighting: 'uniform' },
  },
});

/**
 * By name: the surface (bumps unless named), whether its quads are split into triangles, and the
 * scene, or instead of one the weights of a conformal `map`. `lifted`: six handles, of which the
 * middle one is lifted. `traced`: the energies of every iteration are recorded, natively as well
 * as on the page.
 */
export const problems = {
  A: { scene: { ...circles, weights, closeness: { to: 'surface' } } },
  B: { scene: rigid('faces'), lifted: true },
  C: { triangles: true, scene: rigid('rings'), lifted: true },
  D: { triangles: true, map: 'inverse-area' },
  E: {
    scene: { ...circles, weights, closeness: { to: 'surface', boundary: { corners: 40 } } },
    traced: true,
  },
  circles: { scene: { ...circles, weights: { shape: 5, close: 10 }, closeness: { to: 'rest' } } },
  planes: { scene: { constraints: [{ kind: 'plane', on: 'faces' }], ...free } },
  lscm: { triangles: true, map: 'lscm' },
  'circles near a net': exact('near a principal net', 'circle'),
  'planes near a net': exact('near a principal net', 'plane'),
  'rough circles': exact('rough', 'circle'),
  'rough planes': exact('rough', 'plane'),
};

/** Those that can be chosen by `--problems`. */
export const letters = Object.keys(problems).filter((name) => name.length === 1);

/** The faces of a square grid. */
function facesOf(side, triangles) {
  const faces = [];
  for (let a = 0; a < side * (side - 1); a++) {
    if (a % side === side - 1) continue;
    const [b, c, d] = [a + 1, a + side + 1, a + side];
    if (triangles) faces.push([a, b, c], [a, c, d]);
    else faces.push([a, b, c, d]);
  }
  return faces;
}

/** Returns the text of an OBJ file. */
export function objText(points, faces) {
  const vertexLines = points.map((point) => `v ${point.join(' ')}\n`);
  const faceLines = faces.map((face) => `f ${face.map((vertex) => vertex + 1).join(' ')}\n`);
  return vertexLines.join('') + faceLines.join('');
}

/** The diagonal of the bounding box. */
function sizeOf(points) {
  const extents = [0, 1, 2].map((c) => {
    const values = Float64Array.from(points, (point) => point[c]).sort();
    return values.at(-1) - values[0];
  });
  return Math.hypot(...extents);
}

/** The four corners, a vertex between, and last the middle, which is lifted. */
function handlesOf(points, side) {
  const [last, half, third, quarter] = [side - 1, side >> 1, Math.floor(side / 3), side >> 2];
  const corners = [0, last].flatMap((j) => [0, last].map((i) => [i, j]));
  const places = [...corners, [third, quarter], [half, half]];
  const vertices = places.map(([i, j]) => j * side + i);
  const targets = vertices.map((vertex) => [...points[vertex]]);
  targets.at(-1)[2] += 0.3 * side;
  return { vertices, targets, weight: 100 };
}

/**
 * Returns the problem on a mesh of about `size` vertices: `scene` and `mesh` are the texts of its
 * files at `sceneFile` and `meshFile`, `size` is about the diameter of the bounding sphere, `spare`
 * are vertices that are no handles.
 */
export function problemOf(name, size) {
  const { surface = 'bumps', scene, lifted, triangles, ...rest } = problems[name];
  const side = Math.max(6, Math.round(Math.sqrt(size)));
  const next = random();
  const points = Array.from({ length: side * side }, (_, k) =>
    surfaces[surface](k % side, Math.floor(k / side), side, next),
  );
  const faces = facesOf(side, triangles);
  const handles = lifted ? [handlesOf(points, side)] : [];
  const document = {
    ...{ format: 'shape-up-scene', version: 1, mesh: { file: 'problem.obj' }, ...scene, handles },
    // Hard constraints begin at the converged soft solution, other problems iterate on.
    solver: rest.kind ? {} : { tolerance: 0 },
  };
  const fifth = Math.floor(side / 5);
  const problem = {
    ...{ ...rest, surface, points, faces, handles: handles[0] },
    ...{ scene: JSON.stringify(document), mesh: objText(points, faces) },
    sceneFile: join(benchFolder, 'problem.shapeup.json'),
    meshFile: join(benchFolder, 'problem.obj'),
    spare: [1, 2, 3].map((k) => k * fifth * side + k * fifth + 1),
    vertices: points.length,
    size: sizeOf(points),
  };
  mkdirSync(benchFolder, { recursive: true });
  writeFileSync(problem.sceneFile, problem.scene);
  writeFileSync(problem.meshFile, problem.mesh);
  return problem;
}
