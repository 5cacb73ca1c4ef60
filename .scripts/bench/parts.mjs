// The parts of the benchmark: the problems and sizes that each measures, and the tables of its rows.

import { measurePeer, peers } from './peers.mjs';
import { letters, problemOf } from './problems.mjs';
import { measureStart } from './start.mjs';

const SIZES = { sizes: [2500, 10_000], more: [30_000, 100_000] };

/** Where ours is measured beside a peer: natively if both make panels exact. */
const placeOf = (measure) => (measure === 'exact' ? 'native' : 'browser');

const rowOf = ({ surface, kind, vertices }) => ({ surface, kind, vertices });

/**
 * By name: the `problems` in vertices of `sizes`, with `--full` also of `more`, and the `places` of
 * the measurement of this name, which are both unless named. Two parts have their own `cases` for
 * some options, and `measure` one as a row or several. `readme` is for tables of the README.
 */
export const parts = {
  iterations: {
    problems: ['A', 'B', 'C', 'E'],
    ...SIZES,
    tables: [
      {
        readme: true,
        title: 'In the browser, milliseconds, medians:',
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
        columns: `
          problem | vertices | plain, natively = native.none.total |
          plain, in the browser = browser.none.total |
          quasi-newton, natively = native.quasi-newton.total |
          quasi-newton, in the browser = browser.quasi-newton.total`,
      },
    ],
  },

  maps: {
    problems: ['D'],
    sizes: [2500, 10_000],
    // The paper's largest map has 35,000 vertices.
    more: [35_000, 100_000],
    tables: [
      {
        readme: true,
        title: 'The first conformal map of a visit (problem D), milliseconds:',
        columns: 'vertices | natively = native.cold | in the browser = browser.cold',
      },
    ],
  },

  factors: {
    problems: ['A', 'B', 'C'],
    // Around which the faster one changes.
    sizes: [500, 1000, 2500, 5000, 10_000],
    places: ['browser'],
    tables: [
      {
        title: 'In the browser, from changed constraints to the end of the first iteration, ms:',
        columns: `
          problem | vertices | sprs-ldl = browser.sprs-ldl | supernodal = browser.supernodal`,
      },
    ],
  },

  convergence: {
    // The energy of A is zero in the end: nothing holds the boundary, so that smoothness contracts
    // the mesh on its surface without end.
    problems: ['B', 'C'],
    ...SIZES,
    places: ['browser'],
    tables: [
      {
        readme: true,
        title:
          'Seconds (iterations) from the moved handle until the energy is within 1e-4 of the converged one:',
        columns: `
          problem | vertices | plain = browser.none | quasi-newton = browser.quasi-newton |
          anderson = browser.anderson`,
      },
    ],
  },

  start: {
    cases: ({ where }) => (where.includes('browser') ? [{}] : []),
    measure: measureStart,
    tables: [
      {
        readme: true,
        title:
          'The page with its first model, drawn without a graphics card, in milliseconds. The kB are those until a second and a half later: with what the page keeps for use without a network.',
        columns: `
          visit | first paint = median.painted | model there, solved = median.solved |
          first frame drawn = median.drawn | kB = median.kB`,
      },
    ],
  },

  exact: {
    problems: ['circles near a net', 'planes near a net', 'rough circles', 'rough planes'],
    sizes: [2500, 10_000, 30_000],
    tables: [
      {
        title:
          'From the soft solution until all panels are exact; the memory is that of the module:',
        columns: `
          mesh = surface | panels = kind | vertices | seconds, natively = native.seconds |
          seconds, in the browser = browser.seconds | distance, natively = native.distance |
          distance, in the browser = browser.distance | MB = browser.megabytes`,
      },
    ],
  },

  peers: {
    cases: ({ sizes, where }) =>
      peers
        .filter(({ ours }) => where.includes(placeOf(ours)))
        .flatMap((peer) =>
          peer.problems.map((problem) => ({ problem, size: sizes?.[0] ?? peer.vertices, peer })),
        ),
    async measure({ peer, problem: name, size }, on) {
      const problem = problemOf(name, size);
      const distance = (theirs) => on('native', 'distance', theirs);
      const theirs = await measurePeer(peer, problem, distance);
      const ours = await on(placeOf(peer.ours), peer.ours, problem);
      return { ...rowOf(problem), ...theirs, ours: ours.none ?? ours };
    },
    tables: [
      {
        readme: true,
        title:
          'Other libraries, natively, and what of their problem is equal to ours, in milliseconds:',
        columns: `
          library | what = peer.what | equal = peer.equal | vertices | it = its | ours in the browser = ours.total`,
      },
      {
        title: 'Panels made exact, all natively; distances are relative to the size of the mesh:',
        columns: `
          mesh = surface | panels = kind | library | its way = way |
          its distance = itsDistance | its s = its | our distance = ours.distance |
          our s = ours.seconds`,
      },
    ],
  },
};

/** Returns the cases of a part for some options. */
export function casesOf(name, options) {
  const { cases, problems, sizes, more = [] } = parts[name];
  if (cases) return cases(options);
  const all = options.sizes ?? (options.full ? [...sizes, ...more] : sizes);
  const named = problems.filter((one) => !letters.includes(one) || options.problems.includes(one));
  return all.flatMap((size) => named.map((problem) => ({ problem, size })));
}

/** Measures a case; returns a row or several. `on` performs a measurement in a place. */
export async function measured(name, one, where, on) {
  const { measure, places = ['native', 'browser'] } = parts[name];
  if (measure) return measure(one, on);
  const problem = problemOf(one.problem, one.size);
  const row = rowOf(problem);
  for (const place of places.filter((each) => where.includes(each)))
    row[place] = await on(place, name, problem);
  return row;
}
