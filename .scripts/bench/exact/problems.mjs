// Meshes of quads whose panels are to be circular or flat: near a net of principal curvature lines, where
// little has to change, and rough, where nothing is near.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { benchFolder, objText } from '../problems.mjs';

/** Vertices are moved by up to this part of an edge to each side; half of that in height on the rough one. */
const JITTER = { net: 0.01, rough: 0.15 };

/** Numbers from -1/2 to 1/2, the same in every run. */
function random() {
  let state = 1n;
  return () => {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    return Number(state >> 11n) / 2 ** 53 - 0.5;
  };
}

/** A quarter of a torus, whose lines of edges are its circles. */
function onTorus(x, y) {
  const [along, around] = [0.9 * (x - 0.5), 1.1 * (y - 0.5)];
  const radius = 0.6 + 0.5 * Math.cos(around);
  return [radius * Math.sin(along), 0.5 * Math.sin(around), radius * Math.cos(along)];
}

const onBumps = (x, y) => [
  x,
  y,
  0.1 * Math.sin(3 * x) * Math.cos(4 * y) + 0.05 * Math.sin(7 * x * y),
];

const surfaces = {
  net: { title: 'near a principal net', point: onTorus },
  rough: { title: 'rough', point: onBumps },
};

export const titleOf = (surface) => surfaces[surface].title;

function points(surface, side) {
  const next = random();
  const edge = JITTER[surface] / (side - 1);
  const rows = [];
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const [x, y, z] = surfaces[surface].point(i / (side - 1), j / (side - 1));
      rows.push([x + 2 * edge * next(), y + 2 * edge * next(), z + edge * next()]);
    }
  }
  return rows;
}

/** The diameter of a sphere around all points. */
function sizeOf(rows) {
  const [low, high] = [Math.min, Math.max].map((best) =>
    [0, 1, 2].map((c) => rows.map((row) => row[c]).reduce((a, b) => best(a, b))),
  );
  return Math.hypot(...high.map((value, c) => value - low[c]));
}

/**
 * Writes the mesh and gives the problem, as `problemOf` does, and its `size`, about the diameter of the
 * bounding sphere. `within` is a part of the size, or null for exact. The weights are those of the study
 * that the solver is measured by: closeness to rest 10, smoothness of the displacement 2.
 */
export function exactProblem({ surface, kind, within, vertices }) {
  const side = Math.max(6, Math.round(Math.sqrt(vertices)));
  const rows = points(surface, side);
  const name = `exact-${surface}-${side * side}.obj`;
  const mesh = join(benchFolder, name);
  mkdirSync(benchFolder, { recursive: true });
  writeFileSync(mesh, objText(rows, side, false));
  const size = sizeOf(rows);
  const scene = {
    format: 'shape-up-scene',
    version: 1,
    mesh: { file: name },
    constraints: [
      { kind, on: 'faces', require: within === null ? 'exact' : { within: within * size } },
    ],
    weights: { shape: 5, close: 10, smooth: 2 },
    closeness: { to: 'rest' },
    smoothness: { of: 'displacement', weighting: 'uniform' },
  };
  const none = { move: [], from: [], handles: [], spare: [], traced: false };
  return { ...none, scene: JSON.stringify(scene), mesh, size, vertices: side * side };
}
