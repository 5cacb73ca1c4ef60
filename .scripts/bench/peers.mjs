// Other libraries on the same meshes, natively. pip installs them into a folder under target/; the
// tables say which it cannot install.

import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { at } from '../project.mjs';
import { benchFolder, objText } from './problems.mjs';
import { spread } from './statistics.mjs';

/**
 * Every peer with the problems that it gets, the number of vertices (those that it can do in a
 * reasonable time) and the function of `tests/bench/peers.py`. `equal` is what its problem has in
 * common with ours, unless both make panels exact.
 */
export const peers = [
  {
    library: 'compas_shapeop',
    // It has no closeness to a surface, so that it cannot be asked for problem A itself.
    problems: ['circles'],
    vertices: 10_000,
    call: 'compas_circles',
    what: 'circles, closeness to the rest positions',
    equal: 'the mesh, the constraints, closeness to fixed points',
  },
  {
    library: 'libigl',
    // Its edges are weighted by cotangents, its handles are fixed, ours are soft.
    problems: ['C'],
    vertices: 10_000,
    call: 'libigl_arap',
    what: 'as rigid as possible (spokes), handles',
    equal: 'the mesh, one rotation per vertex, the handles and their move',
  },
  {
    library: 'libigl',
    // It factors in the same call, so that runs of two lengths are compared.
    problems: ['planes'],
    vertices: 2500,
    call: 'libigl_planes',
    what: 'planarize_quad_mesh',
    equal: 'the mesh, a plane for every quad, nothing else',
  },
  {
    library: 'libigl',
    // It holds two vertices and solves one system; ours is free, the smallest eigenvector.
    problems: ['lscm'],
    vertices: 10_000,
    call: 'libigl_lscm',
    what: 'least-squares conformal map, the whole call',
    equal: 'the mesh, the energy',
  },
  {
    library: 'pymeshlab',
    problems: ['lscm'],
    vertices: 10_000,
    call: 'pymeshlab_lscm',
    what: 'least-squares conformal map, the whole filter',
    equal: 'the mesh, the energy',
  },
  {
    library: 'compas_shapeop',
    problems: ['circles near a net', 'planes near a net', 'rough circles', 'rough planes'],
    vertices: 2500,
    call: 'compas_exact',
  },
  {
    library: 'libigl',
    problems: ['planes near a net', 'rough planes'],
    vertices: 2500,
    call: 'libigl_exact',
  },
];

const venv = join(benchFolder, 'peers');
const python = join(venv, 'bin', 'python');
const [taskFile, resultFile] = ['task', 'result'].map((name) =>
  join(benchFolder, `peer-${name}.json`),
);

/** Installs a peer, unless it is there; what cannot be installed cannot be imported. */
function setUp(library) {
  if (!existsSync(python)) spawnSync('python3', ['-m', 'venv', venv]);
  spawnSync(python, ['-m', 'pip', 'install', '--only-binary', ':all:', 'numpy', library]);
}

/** Performs a task in Python; returns its result, or { failed } with the last line of the error. */
function performed(library, call, task) {
  setUp(library);
  writeFileSync(taskFile, JSON.stringify({ library, call, ...task }));
  const words = [at('tests', 'bench', 'peers.py'), taskFile, resultFile];
  // One core each, as ours.
  const env = { ...process.env, OMP_NUM_THREADS: '1', OPENBLAS_NUM_THREADS: '1' };
  const { status, stderr } = spawnSync(python, words, { encoding: 'utf8', env });
  if (status !== 0) return { failed: stderr?.trim().split('\n').at(-1) || 'it fails' };
  return JSON.parse(readFileSync(resultFile, 'utf8'));
}

/** Covers triangles with about as many quads by another library, into a file; returns the seconds and its version. */
export function quadsOf(library, task, path) {
  const { failed, version, steps, points, faces } = performed(library, library, task);
  if (failed) return { failed };
  writeFileSync(path, objText(points, faces));
  return { seconds: spread(steps.map((ms) => ms / 1e3)), version: `${library} ${version}` };
}

/**
 * Measures a peer on a problem: milliseconds per iteration; or the seconds, and the distance of the
 * corners to their circle or plane, of its way that comes closest. `distance` measures a problem.
 */
export async function measurePeer({ library, call }, problem, distance) {
  const { points, faces, handles, kind } = problem;
  const task = { kind, handles, points, faces };
  const { failed, version, steps, ways } = performed(library, call, task);
  if (failed) return { library, its: failed };
  const named = { library: `${library} ${version}` };
  if (steps) return { ...named, its: spread(steps) };
  const meshFile = join(benchFolder, 'peer.obj');
  const found = [];
  for (const { way, ms, shape } of ways) {
    writeFileSync(meshFile, objText(shape, faces));
    const itsDistance = await distance({ ...problem, meshFile });
    found.push({ ...named, way, its: spread([ms / 1e3]), itsDistance });
  }
  found.sort((a, b) => a.itsDistance - b.itsDistance);
  return found[0] ?? { ...named, way: 'the mesh collapses in every way' };
}
