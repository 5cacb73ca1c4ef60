// Other libraries on the same meshes, natively. pip installs them into a folder under target/;
// those that it cannot install are skipped, as the tables report.

import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { at } from '../project.mjs';
import { outputOf, say } from '../run.mjs';
import { benchFolder, problemOf } from './problems.mjs';
import { median } from './statistics.mjs';

const venv = join(benchFolder, 'peers');
const python = join(venv, 'bin', 'python');

/**
 * Task of each peer, and the problem whose mesh it gets. `largest`: number of vertices above which
 * it takes too long; `equal` and `differs` describe what is comparable.
 */
export const comparisons = [
  {
    peer: 'compas_shapeop',
    call: 'compas_circles',
    problem: 'circles',
    steps: 21,
    largest: 100_000,
    what: 'circles, closeness to the rest positions',
    equal: 'the mesh, the constraints, closeness to fixed points',
    differs: 'it has no closeness to a surface, so that it cannot be asked for problem A itself',
  },
  {
    peer: 'libigl',
    call: 'libigl_arap',
    problem: 'C',
    steps: 5,
    largest: 30_000,
    what: 'as rigid as possible (spokes), handles',
    equal: 'the mesh, one rotation per vertex, the handles and their move',
    differs: 'its edges are weighted by cotangents, its handles are fixed, ours are soft',
  },
  {
    peer: 'libigl',
    call: 'libigl_planes',
    problem: 'planes',
    steps: 2,
    largest: 2_500,
    what: 'planarize_quad_mesh',
    equal: 'the mesh, a plane for every quad, nothing else',
    differs: 'it factors in the same call, so that runs of two lengths are compared',
  },
  {
    peer: 'libigl',
    call: 'libigl_lscm',
    problem: 'lscm',
    steps: 1,
    largest: 100_000,
    what: 'least-squares conformal map, the whole call',
    equal: 'the mesh, the energy',
    differs: 'it holds two vertices and solves one system; ours is free, the smallest eigenvector',
  },
];

/** Installs the peers and returns the version of each, or the reason why it is missing. */
export function setUpPeers() {
  const names = [...new Set(comparisons.map(({ peer }) => peer))];
  if (!existsSync(python)) {
    say('making a folder for the peers under target/');
    const made = spawnSync('python3', ['-m', 'venv', venv], { encoding: 'utf8' });
    if (made.status !== 0) {
      const reason = 'there is no Python 3 with venv';
      return Object.fromEntries(names.map((name) => [name, { reason }]));
    }
  }
  const found = names.map((name) => {
    const version = () => outputOf(python, ['-c', versionOf(name)]);
    if (!version()) {
      say(`installing ${name} from PyPI under target/`);
      spawnSync(python, ['-m', 'pip', 'install', '--only-binary', ':all:', 'numpy', name], {
        encoding: 'utf8',
      });
    }
    return [name, version() ? { version: version() } : { reason: 'pip cannot install it here' }];
  });
  return Object.fromEntries(found);
}

const versionOf = (name) => `import importlib.metadata as m; print(m.version("${name}"))`;

/** Measures one comparison at one size: milliseconds, or the reason why not. */
export function measurePeer({ call, problem, steps, largest }, size) {
  const { mesh, handles, move, vertices } = problemOf(problem, size);
  if (vertices > largest * 1.01) return { reason: 'takes too long' };
  const result = askPeer({ call, mesh, handles, move, steps });
  return result.reason ? result : { setUp: result.setUp, ms: median(result.steps) };
}

/** Returns the answer of `tests/bench/peers.py` to a task, or the reason of its failure. */
export function askPeer(task) {
  const files = ['peer-task.json', 'peer-result.json'].map((name) => join(benchFolder, name));
  writeFileSync(files[0], JSON.stringify(task));
  const program = at('tests', 'bench', 'peers.py');
  const { status, stderr } = spawnSync(python, [program, ...files], {
    encoding: 'utf8',
    // One core each, as ours.
    env: { ...process.env, OMP_NUM_THREADS: '1', OPENBLAS_NUM_THREADS: '1' },
  });
  if (status !== 0) return { reason: stderr.trim().split('\n').at(-1) ?? 'it fails' };
  return JSON.parse(readFileSync(files[1], 'utf8'));
}
