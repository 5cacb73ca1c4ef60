// The parts of the benchmark: the problems and sizes that each measures, and the tables of its rows.

import { measureLimits } from './limits.mjs';
import { measurePeer, peers } from './peers.mjs';
import { letters, problemOf } from './problems.mjs';
import { measureQuads, quadCases } from './quads.mjs';
import { measureStart } from './start.mjs';

const SIZES = { sizes: [2500, 10_000], more: [30_000, 100_000] };

/** Where ours is measured beside a peer: natively if both make panels exact. */
const placeOf = (peer) => (peer.what ? 'browser' : 'native');

const rowOf = ({ surface, kind, vertices }) => ({ surface, kind, vertices });

/**
 * By name: the `problems` in vertices of `sizes`, with `--full` also of `more`, and the `places` of
 * the measurement of this name, which are both unless named. Some parts have their own `cases` for
 * the options, or `measure` one as a row or several. `tables` are columns by title.
 */
export const parts = {
  iterations: {
    problems: ['A', 'B', 'C', 'E'],
    ...SIZES,
    tables: {
      'In the browser, milliseconds, medians:': `
        problem | vertices | iteration = browser.quasi-newton.total |
        of it projections = browser.quasi-newton.shape |
        closeness = browser.quasi-newton.close | global step = browser.quasi-newton.global |
        file opened = browser.quasi-newton.opened |
        constraints changed = browser.quasi-newton.change |
        handle added = browser.quasi-newton.handle`,
      'An iteration by accelerator and place, milliseconds:': `
        problem | vertices | plain, natively = native.none.total |
        plain, in the browser = browser.none.total |
        quasi-newton, natively = native.quasi-newton.total |
        quasi-newton, in the browser = browser.quasi-newton.total`,
    },
  },

  limits: {
    problems: ['A', 'B', 'C'],
    ...SIZES,
    measure: ({ problem, size }, on, where) =>
      where.length === 2 ? measureLimits(problemOf(problem, size), on) : [],
    tables: {
      'The global step in the browser beside what this machine can do at best. A solve reads the factor twice, which moves as many bytes as a copy of it; and it multiplies and adds each of its numbers twice for three coordinates, four at a time in registers. The step also has the gradient and what the accelerator combines. Milliseconds:': `
        problem | vertices | MB to move = limit.MB | to move them = limit.moved |
        to compute = limit.computed | at 1e9 operations a second = limit.perSecond |
        global step = limit.global | times the larger = limit.times`,
    },
  },

  maps: {
    problems: ['D'],
    sizes: [2500, 10_000],
    // The paper's largest map has 35,000 vertices.
    more: [35_000, 100_000],
    tables: {
      'The first conformal map of a visit (problem D), milliseconds:':
        'vertices | natively = native.cold | in the browser = browser.cold',
    },
  },

  factors: {
    problems: ['A', 'B', 'C'],
    // Around which the faster one changes.
    sizes: [500, 1000, 2500, 5000, 10_000],
    places: ['browser'],
    tables: {
      'In the browser, from changed constraints to the end of the first iteration, ms:': `
        problem | vertices | sprs-ldl = browser.sprs-ldl | supernodal = browser.supernodal`,
    },
  },

  convergence: {
    // The energy of A is zero in the end: nothing holds the boundary, so that smoothness contracts
    // the mesh on its surface without end.
    problems: ['B', 'C'],
    ...SIZES,
    places: ['browser'],
    tables: {
      'Seconds (iterations) from the moved handle until the energy is within 1e-4 of the converged one:': `
        problem | vertices | plain = browser.none | quasi-newton = browser.quasi-newton |
        anderson = browser.anderson`,
    },
  },

  start: {
    cases: ({ where }) => (where.includes('browser') ? [{}] : []),
    measure: measureStart,
    tables: {
      'The page with its first model, drawn without a graphics card, in milliseconds. The kB are those until a second and a half later: with what the page keeps for use without a network.': `
        visit | first paint = median.painted | model there, solved = median.solved |
        first frame drawn = median.drawn | kB = median.kB`,
    },
  },

  exact: {
    problems: ['circles near a net', 'planes near a net', 'rough circles', 'rough planes'],
    sizes: [2500, 10_000, 30_000],
    tables: {
      'From the soft solution until all panels are exact; the memory is that of the module:': `
        mesh = surface | panels = kind | vertices | seconds, natively = native.seconds |
        seconds, in the browser = browser.seconds | distance, natively = native.distance |
        distance, in the browser = browser.distance | MB = browser.megabytes`,
    },
  },

  quads: {
    cases: (options) => (options.where.includes('native') ? quadCases(options) : []),
    measure: measureQuads,
    tables: {
      'Quads on triangulated roofs, and the same made circular; moves are in mean edges of the panels:': `
        surface | triangles | by = library | panels = quads.made | irregular = quads.irregular |
        degrees off the lines of curvature = quads.degrees | mean move = quads.mean |
        largest = quads.max | folded = quads.folded | verdict = quads.level |
        s, natively = seconds.native | s, in the browser = seconds.browser`,
    },
  },

  peers: {
    cases: ({ sizes, where }) =>
      peers
        .filter((peer) => where.includes(placeOf(peer)))
        .flatMap((peer) =>
          peer.problems.map((problem) => ({ problem, size: sizes?.[0] ?? peer.vertices, peer })),
        ),
    async measure({ peer, problem: name, size }, on) {
      const problem = problemOf(name, size);
      const distance = (theirs) => on('native', 'distance', theirs);
      const theirs = await measurePeer(peer, problem, distance);
      const { what, equal } = peer;
      const measure = problem.map ? 'maps' : what ? 'iterations' : 'exact';
      const ours = await on(placeOf(peer), measure, problem);
      return { what, equal, ...rowOf(problem), ...theirs, ours: ours.none ?? ours };
    },
    tables: {
      'Other libraries, natively, and what of their problem is equal to ours, in milliseconds:': `
        library | what | equal | vertices | it = its | ours in the browser = ours.total`,
      'Panels made exact, all natively; distances are relative to the size of the mesh:': `
        mesh = surface | panels = kind | library | its way = way |
        its distance = itsDistance | its s = its | our distance = ours.distance |
        our s = ours.seconds`,
    },
  },
};

/** Returns [title, columns] of the tables of a part. */
export const tablesOf = (name) => Object.entries(parts[name].tables);

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
  if (measure) return measure(one, on, where);
  const problem = problemOf(one.problem, one.size);
  const row = rowOf(problem);
  for (const place of places.filter((each) => where.includes(each)))
    row[place] = await on(place, name, problem);
  return row;
}
