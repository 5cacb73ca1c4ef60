// The parts of the benchmark: what each measures, case by case, and the tables of its rows.

import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { measurePeer, peers } from './peers.mjs';
import { problemOf, problems } from './problems.mjs';
import { measureStart } from './start.mjs';

const PLACES = ['native', 'browser'];
/** Sizes around which the faster numeric factor changes. */
const FACTOR_SIZES = [500, 1000, 2500, 5000, 10_000];
const EXACT_SIZES = [2500, 10_000, 30_000];
/** The longest that a run may take to converge. */
const LIMIT_MS = 3000;

/** All combinations of some lists, as objects. */
function combined(lists) {
  return Object.entries(lists).reduce(
    (all, [key, list]) => all.flatMap((one) => list.map((value) => ({ ...one, [key]: value }))),
    [{}],
  );
}

/** Returns an object of the values that are computed one after the other. */
async function byKey(keys, valueOf) {
  const values = {};
  for (const key of keys) values[key] = await valueOf(key);
  return values;
}

/** Maps have as many vertices as the paper's, 35,000, in place of 30,000. */
const sizeIn = (name, size) => (problems[name].map && size === 30_000 ? 35_000 : size);

/**
 * By name: the `cases` for some options, and how one is `measure`d, as a row or several. `on` does a
 * measurement of a problem in a place, or nothing if that place is not wanted. `usual` parts are
 * measured unless others are named; `readme` is for tables of the README.
 */
export const parts = {
  iterations: {
    usual: true,
    cases: ({ names, sizes }) => combined({ size: sizes, problem: names }),
    async measure({ problem: name, size }, { on, trial }) {
      const problem = problemOf(name, sizeIn(name, size));
      const { map, vertices } = problem;
      const iterate = (place, accelerator) => {
        const task = { edits: accelerator === 'none' ? 0 : 5, least: trial ? 0 : 1500 };
        return on(place, 'iterations', problemOf(name, size, { accelerator }), task);
      };
      const byPlace = (place) =>
        map
          ? on(place, 'map', problem)
          : byKey(['none', 'quasi-newton'], (accelerator) => iterate(place, accelerator));
      const iterated = map ? undefined : true;
      return { map, iterated, vertices, ...(await byKey(PLACES, byPlace)) };
    },
    tables: [
      {
        readme: true,
        title: 'In the browser, milliseconds, medians:',
        has: 'browser.quasi-newton',
        columns: `
          problem | vertices | iteration = browser.quasi-newton.total |
          of it projections = browser.quasi-newton.shape |
          closeness = browser.quasi-newton.close | global step = browser.quasi-newton.global |
          file opened = browser.quasi-newton.opened |
          constraints changed = browser.quasi-newton.change |
          handle added = browser.quasi-newton.handle`,
      },
      {
        title: 'An iteration by accelerator and place, milliseconds:',
        has: 'iterated',
        columns: `
          problem | vertices | plain, natively = native.none.total |
          plain, in the browser = browser.none.total |
          quasi-newton, natively = native.quasi-newton.total |
          quasi-newton, in the browser = browser.quasi-newton.total`,
      },
      {
        readme: true,
        title: 'The first conformal map of a visit (problem D), milliseconds:',
        has: 'map',
        columns: 'vertices | natively = native.cold | in the browser = browser.cold',
      },
    ],
  },

  factors: {
    cases: ({ trial }) => combined({ size: trial ? [400] : FACTOR_SIZES }),
    measure({ size }, { on, trial }) {
      const rounds = trial ? 1 : Math.max(7, Math.min(41, Math.round(60_000 / size)));
      const of = (name) => on('browser', 'factors', problemOf(name, size), { rounds });
      return byKey(['A', 'B', 'C'], of);
    },
    tables: [
      {
        title: 'In the browser, from changed constraints to the end of the first iteration, ms:',
        has: 'A',
        columns: `
          vertices = A.vertices | A: sprs-ldl = A.sprs-ldl | A: supernodal = A.supernodal |
          B: sprs-ldl = B.sprs-ldl | B: supernodal = B.supernodal | C: sprs-ldl = C.sprs-ldl |
          C: supernodal = C.supernodal`,
      },
    ],
  },

  convergence: {
    usual: true,
    cases: ({ names, sizes }) =>
      combined({ size: sizes, problem: names.filter((name) => problems[name].converges) }),
    measure: ({ problem, size }, { on }) =>
      on('browser', 'convergence', problemOf(problem, size), { limit: LIMIT_MS }),
    tables: [
      {
        readme: true,
        title:
          'Seconds (iterations) from the moved handle until the energy is within 1e-4 of the converged one:',
        // Where that energy is certain.
        has: 'none',
        columns: 'problem | vertices | plain = none | quasi-newton | anderson',
      },
    ],
  },

  start: {
    usual: true,
    cases: ({ where }) => (where.includes('browser') ? [{}] : []),
    measure: (_, { full }) => measureStart(full ? 5 : 3),
    tables: [
      {
        readme: true,
        title:
          'The page with its first model, drawn without a graphics card, in milliseconds. The kB are those until a second and a half later: with what the page keeps for use without a network.',
        has: 'visit',
        columns: `
          visit | first paint = painted | model there, solved = solved |
          first frame drawn = drawn | kB`,
      },
    ],
  },

  exact: {
    cases: ({ trial }) =>
      combined({
        size: trial ? [144] : EXACT_SIZES,
        problem: Object.keys(problems).filter((name) => problems[name].kind),
      }),
    async measure({ problem: name, size }, { on }) {
      const problem = problemOf(name, size);
      const { surface, kind, vertices } = problem;
      const found = await byKey(PLACES, (place) => on(place, 'exact', problem));
      return {
        surface,
        kind,
        vertices,
        distance: (found.browser ?? found.native).distance,
        ...found,
      };
    },
    tables: [
      {
        title:
          'From the soft solution until all panels are exact; the memory is that of the module:',
        has: 'distance',
        columns: `
          mesh = surface | panels = kind | vertices | seconds, natively = native.seconds |
          seconds, in the browser = browser.seconds | distance | MB = browser.megabytes`,
      },
    ],
  },

  peers: {
    cases: () => peers.flatMap((peer) => combined({ peer: [peer], problem: peer.problems })),
    async measure({ peer, problem: name }, { on, trial }) {
      const { what, equal, vertices: size } = peer;
      const problem = problemOf(name, trial ? 144 : size, what ? { accelerator: 'none' } : {});
      const { surface, kind, map, vertices } = problem;
      const theirs = measurePeer(trial ? { ...peer, iterations: 2 } : peer, problem);
      const measure = map ? 'map' : what ? 'iterations' : 'exact';
      const task = { edits: 0, least: trial ? 0 : 1500 };
      const ours = await on(what ? 'browser' : 'native', measure, problem, task);
      return { what, equal, surface, kind, vertices, ...theirs, ours };
    },
    tables: [
      {
        readme: true,
        title:
          'Other libraries, natively, and what of their problem is equal to ours, in milliseconds:',
        has: 'what',
        columns: `
          library | what | equal | vertices | it = its | ours in the browser = ours.total`,
      },
      {
        title: 'Panels made exact, all natively; distances are relative to the size of the mesh:',
        has: 'kind',
        columns: `
          mesh = surface | panels = kind | library | its way = way |
          its distance = itsDistance | its s = its | our distance = ours.distance |
          our s = ours.seconds`,
      },
    ],
  },

  folds: {
    cases: ({ meshes }) =>
      combined({ mesh: meshes, kind: ['circle', 'plane'], way: ['press', 'within', 'exact'] }),
    measure: ({ mesh, kind, way }, { on }) =>
      on('browser', 'folds', { name: basename(mesh), text: readFileSync(mesh, 'utf8'), kind, way }),
    tables: [
      {
        title:
          'Panels of real meshes: by the button ("press"), within its tolerance, and exact. Lengths are relative to the mean edge, energies without the constraints:',
        has: 'folded',
        columns: `
          mesh | panels = kind | way | folded | met | eased | tolerance | farthest | moved |
          mean | energy | attempts | s = seconds`,
      },
    ],
  },
};
