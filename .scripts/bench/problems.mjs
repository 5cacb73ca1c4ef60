// The measured problems, on meshes of any size: scenes, and mesh files that all participants read.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { targetFolder } from '../project.mjs';

/** Folder for all output of the benchmark. */
export const benchFolder = join(targetFolder, 'bench');

/** Accelerators, as named in scene files. */
export const accelerators = ['none', 'quasi-newton', 'anderson'];
const rigid = {
  weights: { shape: 1 },
  closeness: { to: 'none' },
  handles: true,
  converges: true,
};
const circles = { kind: 'circle', on: 'faces' };
const circular = {
  mesh: 'quads',
  constraints: [circles],
  weights: { shape: 5, close: 10, smooth: 2 },
};

/**
 * By letter: title, mesh and scene of each problem. `maps` marks a conformal map instead of a
 * scene, `for` a problem measured only beside a peer, `named` one measured only on request.
 * `converges`: its energy has a minimum to compare with. That of A is zero: nothing holds the
 * boundary, so that smoothness contracts the mesh on its surface without end.
 */
export const problems = {
  A: {
    title: 'a circle for every quad, weights 5, 10, 2, closeness to the surface',
    ...circular,
    closeness: { to: 'surface' },
  },
  B: {
    title: 'every quad rigid, six handles',
    mesh: 'quads',
    constraints: [{ kind: 'rigid', on: 'faces' }],
    ...rigid,
  },
  C: {
    title: 'the one-ring of every vertex rigid, on triangles, six handles',
    mesh: 'triangles',
    constraints: [{ kind: 'rigid', on: 'rings' }],
    ...rigid,
  },
  D: { title: 'a conformal map of triangles', mesh: 'triangles', maps: 'inverse-area' },
  E: {
    title: 'A with the boundary close to its curves, and every iteration recorded',
    ...circular,
    closeness: { to: 'surface', boundary: { corners: 40 } },
    traced: true,
    named: true,
  },
  circles: {
    title: 'a circle for every quad, every vertex close to where it was (weights 5, 10)',
    mesh: 'quads',
    constraints: [circles],
    weights: { shape: 5, close: 10 },
    closeness: { to: 'rest' },
    for: 'compas_shapeop',
  },
  planes: {
    title: 'a plane for every quad, and nothing else',
    mesh: 'quads',
    constraints: [{ kind: 'plane', on: 'faces' }],
    weights: { shape: 1 },
    closeness: { to: 'none' },
    for: 'libigl',
  },
  lscm: { title: 'a conformal map of triangles', mesh: 'triangles', maps: 'lscm', for: 'libigl' },
};

/** A number from -1/2 to 1/2, determined by a grid point and a channel. */
const jitter = (i, j, channel) => ((i * 7919 + j * 104729 + channel * 1299709) % 1009) / 1009 - 0.5;

/** Returns the points of a jittered, bumpy height field with edges of about 1, `#V` rows of 3. */
function points(side, seed) {
  const rows = [];
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const shift = (channel) => 0.3 * jitter(i + seed, j, channel);
      const wave = Math.sin((5 * i) / side) * Math.cos((4 * j) / side);
      rows.push([i + shift(1), j + shift(2), 0.1 * side * wave + 0.3 * shift(3)]);
    }
  }
  return rows;
}

/** Returns the corners of every quad. */
function quads(side) {
  const rows = [];
  for (let j = 0; j + 1 < side; j++) {
    for (let i = 0; i + 1 < side; i++) {
      const a = j * side + i;
      rows.push([a, a + 1, a + side + 1, a + side]);
    }
  }
  return rows;
}

/** Returns the text of an OBJ file of a square grid of quads, optionally split into triangles. */
export function objText(rows, side, triangles) {
  const lines = rows.map((row) => `v ${row.join(' ')}`);
  for (const corners of quads(side)) {
    const [a, b, c, d] = corners.map((corner) => corner + 1);
    if (triangles) lines.push(`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`);
    else lines.push(`f ${a} ${b} ${c} ${d}`);
  }
  return `${lines.join('\n')}\n`;
}

/** Writes a quad mesh of about `size` vertices; returns the path of its file, and its arrays. */
export function quadsOf(size) {
  const side = Math.round(Math.sqrt(size));
  const rows = points(side, 0);
  const mesh = join(benchFolder, `quads-${side * side}.obj`);
  mkdirSync(benchFolder, { recursive: true });
  writeFileSync(mesh, objText(rows, side, false));
  const faces = quads(side);
  return {
    mesh,
    positions: Float64Array.from(rows.flat()),
    offsets: Uint32Array.from({ length: faces.length + 1 }, (_, face) => 4 * face),
    indices: Uint32Array.from(faces.flat()),
  };
}

/** The four corners, the middle, and a vertex between. */
function sixHandles(side) {
  const at = (i, j) => j * side + i;
  const [last, half, third, quarter] = [side - 1, side >> 1, Math.floor(side / 3), side >> 2];
  const corners = [at(0, 0), at(last, 0), at(0, last), at(last, last)];
  return { all: [...corners, at(half, half), at(third, quarter)], middle: at(half, half) };
}

/**
 * Writes the mesh of a problem and returns the problem: `mesh` is the path of its file, `move` the
 * handles that are moved at the start with their targets, `from` their rest positions, `spare`
 * vertices that are no handles. `seed` selects another mesh of the same kind.
 */
export function problemOf(letter, size, { accelerator = 'quasi-newton', seed = 0 } = {}) {
  const { mesh: kind, handles: held, constraints, weights, closeness, traced } = problems[letter];
  const side = Math.max(6, Math.round(Math.sqrt(size)));
  const rows = points(side, seed);
  mkdirSync(benchFolder, { recursive: true });
  const name = `${kind}-${side * side}${seed ? `-${seed}` : ''}.obj`;
  const mesh = join(benchFolder, name);
  writeFileSync(mesh, objText(rows, side, kind === 'triangles'));

  const { all, middle } = sixHandles(side);
  const [x, y, z] = rows[middle];
  const scene = {
    format: 'shape-up-scene',
    version: 1,
    mesh: { file: name },
    constraints,
    handles: held ? [{ vertices: all, weight: 100 }] : [],
    weights,
    closeness,
    solver: { accelerator, tolerance: 0 },
  };
  const fifth = Math.floor(side / 5);
  return {
    scene: JSON.stringify(scene),
    mesh,
    // The middle is lifted by three tenths of the width.
    move: held ? [[middle, [x, y, z + 0.3 * side]]] : [],
    from: held ? [rows[middle]] : [],
    handles: all,
    traced: traced ?? false,
    spare: [1, 2, 3].map((k) => k * fifth * side + k * fifth + 1),
    vertices: side * side,
  };
}
