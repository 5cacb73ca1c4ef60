// Quad meshes to be made circular or planar: one near a principal curvature net, where little has
// to change, and a rough one, where no solution is near.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { benchFolder, objText } from '../problems.mjs';

/** Largest displacement of vertices relative to an edge; half of it in height. */
const JITTER = { net: 0.01, rough: 0.15 };

/** Returns a generator of numbers from -1/2 to 1/2, the same in every run. */
function random() {
  let state = 1n;
  return () => {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    return Number(state >> 11n) / 2 ** 53 - 0.5;
  };
}

/** A quarter of a torus, whose edge lines are its principal circles. */
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

/** The diagonal of the bounding box. */
function sizeOf(rows) {
  const [low, high] = [Math.min, Math.max].map((best) =>
    [0, 1, 2].map((c) => rows.map((row) => row[c]).reduce((a, b) => best(a, b))),
  );
  return Math.hypot(...high.map((value, c) => value - low[c]));
}

/**
 * Writes the mesh and returns the problem as `problemOf` does, with its `size`, about the diameter
 * of the bounding sphere. `within` is relative to the size, or null for exact. The weights are
 * those of the reference study: closeness to rest 10, smoothness of the displacement 2.
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
