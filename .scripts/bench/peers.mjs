// Other libraries on the same meshes, natively. pip installs them into a folder under target/;
// those that it cannot install are skipped, as the tables report.

import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { at } from '../project.mjs';
import { outputOf, say } from '../run.mjs';
import { benchFolder } from './problems.mjs';
import { median } from './statistics.mjs';

/**
 * Every peer with the problems that it gets, the number of vertices (those that it can do in a
 * reasonable time), the function of `tests/bench/peers.py` and its number of iterations. `equal` is
 * what its problem has in common with ours.
 */
export const peers = [
  {
    library: 'compas_shapeop',
    // It has no closeness to a surface, so that it cannot be asked for problem A itself.
    problems: ['circles'],
    vertices: 10_000,
    call: 'compas_circles',
    iterations: 21,
    what: 'circles, closeness to the rest positions',
    equal: 'the mesh, the constraints, closeness to fixed points',
  },
  {
    library: 'libigl',
    // Its edges are weighted by cotangents, its handles are fixed, ours are soft.
    problems: ['C'],
    vertices: 10_000,
    call: 'libigl_arap',
    iterations: 5,
    what: 'as rigid as possible (spokes), handles',
    equal: 'the mesh, one rotation per vertex, the handles and their move',
  },
  {
    library: 'libigl',
    // It factors in the same call, so that runs of two lengths are compared.
    problems: ['planes'],
    vertices: 2500,
    call: 'libigl_planes',
    iterations: 2,
    what: 'planarize_quad_mesh',
    equal: 'the mesh, a plane for every quad, nothing else',
  },
  {
    library: 'libigl',
    // It holds two vertices and solves one system; ours is free, the smallest eigenvector.
    problems: ['lscm'],
    vertices: 10_000,
    call: 'libigl_lscm',
    iterations: 1,
    what: 'least-squares conformal map, the whole call',
    equal: 'the mesh, the energy',
  },
  {
    library: 'compas_shapeop',
    problems: ['circles near a net', 'planes near a net', 'rough circles', 'rough planes'],
    vertices: 2500,
    call: 'compas_exact',
    iterations: 2000,
  },
  {
    library: 'libigl',
    problems: ['planes near a net', 'rough planes'],
    vertices: 2500,
    call: 'libigl_exact',
    iterations: 100,
  },
];

const venv = join(benchFolder, 'peers');
const python = join(venv, 'bin', 'python');
const files = ['peer-task.json', 'peer-result.json'].map((name) => join(benchFolder, name));

const versionOf = (library) =>
  existsSync(python)
    ? outputOf(python, ['-c', `import importlib.metadata as m; print(m.version("${library}"))`])
    : null;

/** Installs a peer if it is missing; returns its version, or null if that fails. */
function setUp(library) {
  if (!existsSync(python)) spawnSync('python3', ['-m', 'venv', venv]);
  if (!versionOf(library) && existsSync(python)) {
    say(`installing ${library} from PyPI under target/`);
    spawnSync(python, ['-m', 'pip', 'install', '--only-binary', ':all:', 'numpy', library]);
  }
  return versionOf(library);
}

/** Measures a peer on a problem: milliseconds per iteration, or seconds and the distance reached. */
export function measurePeer({ library: name, call, iterations }, problem) {
  const version = setUp(name);
  if (!version) return { library: name, its: 'pip cannot install it here' };
  const library = `${name} ${version}`;
  const { handles, kind } = problem;
  const task = { call, kind, iterations, handles, mesh: problem.meshFile };
  writeFileSync(files[0], JSON.stringify(task));
  const { status, stderr } = spawnSync(python, [at('tests', 'bench', 'peers.py'), ...files], {
    encoding: 'utf8',
    // One core each, as ours.
    env: { ...process.env, OMP_NUM_THREADS: '1', OPENBLAS_NUM_THREADS: '1' },
  });
  if (status !== 0) return { library, its: stderr.trim().split('\n').at(-1) || 'it fails' };
  const { steps, ms, distance, way } = JSON.parse(readFileSync(files[1], 'utf8'));
  if (steps) return { library, its: median(steps) };
  return { library, way, its: ms / 1e3, itsDistance: distance / problem.size };
}
