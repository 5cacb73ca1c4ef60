// Hard constraints met from the soft solution, and the counterparts of other libraries.

import { say } from '../../run.mjs';
import { askPeer, setUpPeers } from '../peers.mjs';
import { exactProblem } from './problems.mjs';

const KINDS = ['circle', 'plane'];
const SIZES = [2500, 10_000, 30_000];
/** A tolerance, relative to the size. */
const WITHIN = 1e-3;
const WITHIN_AT = 10_000;
/** Largest number of vertices with variations, and their step along a mode relative to the size. */
const VARIED = 2500;
const STEP = 0.02;

/** Peers, each on every problem up to its largest number of vertices. */
const peers = [
  {
    peer: 'compas_shapeop',
    call: 'compas_exact',
    kinds: KINDS,
    largest: 2500,
    iterations: 2000,
  },
  {
    peer: 'libigl',
    call: 'libigl_exact',
    kinds: ['plane'],
    largest: 2500,
    iterations: 100,
    way: 'planarize_quad_mesh, 100 iterations',
  },
];

function problemsOf(sizes) {
  const each = sizes.flatMap((vertices) =>
    ['net', 'rough'].flatMap((surface) =>
      KINDS.map((kind) => ({ surface, kind, within: null, vertices })),
    ),
  );
  const within = sizes
    .filter((vertices) => vertices === WITHIN_AT)
    .flatMap((vertices) =>
      ['net', 'rough'].map((surface) => ({ surface, kind: 'circle', within: WITHIN, vertices })),
    );
  return [...each, ...within];
}

const inSizes = (step, size) => ({ ...step, distance: step.distance / size });

/** Returns a row for each problem and place. */
export async function measureExact({ places, trial }) {
  const rows = [];
  for (const asked of problemsOf(trial ? [144] : SIZES)) {
    const problem = exactProblem(asked);
    for (const [where, place] of Object.entries(places)) {
      say(
        `${asked.kind} ${asked.surface}, ${problem.vertices} vertices, ${where}: hard constraints`,
      );
      const step = asked.within === null && asked.vertices <= VARIED ? STEP : null;
      const { total, exact, bytes, varied } = await place.perform({
        ...{ measure: 'exact', problem, step },
      });
      rows.push({
        ...asked,
        vertices: problem.vertices,
        where,
        soft: total / 1e3 - exact.seconds,
        seconds: exact.seconds,
        iterations: exact.iterations,
        blockFactors: exact.block_factors,
        distance: exact.max_distance / problem.size,
        moved: exact.moved.max / problem.size,
        shortestEdge: exact.shortest_edge,
        unmet: exact.misses,
        bytes: bytes ?? null,
        varied: varied
          ? { ...varied, steps: varied.steps.map((one) => inSizes(one, problem.size)) }
          : null,
      });
    }
  }
  return rows;
}

/** Measures peers on the same meshes: seconds, and distances by the same measure for all. */
export function measureExactPeers({ trial }) {
  const found = setUpPeers();
  const rows = [];
  for (const asked of problemsOf(trial ? [144] : SIZES).filter(({ within }) => within === null)) {
    for (const { peer, call, kinds, largest, iterations, way } of peers) {
      if (!kinds.includes(asked.kind) || asked.vertices > largest) continue;
      const { version, reason } = found[peer];
      const { mesh, size, vertices } = exactProblem(asked);
      say(`${peer}, ${asked.kind} ${asked.surface}, ${vertices} vertices`);
      const theirs = version
        ? askPeer({ call, mesh, kind: asked.kind, iterations: trial ? 2 : iterations })
        : { reason };
      const distance = theirs.distance === undefined ? null : theirs.distance / size;
      const seconds = theirs.ms === undefined ? null : theirs.ms / 1e3;
      const reached = { distance, seconds, reason: theirs.reason ?? null };
      const its = theirs.way ? `${theirs.way}, ${iterations} iterations` : (way ?? '');
      rows.push({ ...asked, vertices, peer, version: version ?? null, way: its, ...reached });
    }
  }
  return rows;
}
