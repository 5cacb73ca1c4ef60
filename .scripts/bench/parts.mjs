// The parts of the benchmark: the problems and sizes that each measures, and the tables of its rows.

import { measurePeer, peers } from './peers.mjs';
import { letters, problemOf } from './problems.mjs';
import { measureQuads, quadCases } from './quads.mjs';
import { measureStart } from './start.mjs';
import { repeated } from './statistics.mjs';
import { number } from './tables.mjs';
import { formulas, measureLimits, reasons } from './work.mjs';

const SIZES = [2500, 10_000];

const rowOf = ({ surface, kind, vertices }) => ({ surface, kind, vertices });

/**
 * By name: the `problems` in vertices of `sizes`, with `--full` also of `more`, and the `places` of
 * the measurement of this name, which are both unless named; it is made several times if it `repeats`
 * a time. Some parts have their own `cases` for the options, or `measure` one as a row or several.
 * `tables` are columns by title, `texts` of the rows follow them.
 */
export const parts = {
  iterations: {
    problems: ['A', 'B', 'C', 'E'],
    sizes: SIZES,
    more: [500, 1000, 30_000, 100_000],
    async measure(one, on, where) {
      const row = await measuredIn('iterations', one, where, on);
      if (where.length < 2) return row;
      const times = row.browser['quasi-newton'];
      const limit = await measureLimits(problemOf(one.problem, one.size), times, on);
      return { ...row, limit };
    },
    tables: {
      'In the browser, milliseconds, medians:': `
        problem | vertices | iteration = browser.quasi-newton.total |
        of it projections = browser.quasi-newton.shape |
        closeness = browser.quasi-newton.close | smoothness = browser.quasi-newton.smooth |
        global step = browser.quasi-newton.global | file opened = browser.quasi-newton.opened |
        constraints changed = browser.quasi-newton.change |
        handle added = browser.quasi-newton.handle`,
      'An iteration by accelerator and place, milliseconds:': `
        problem | vertices | plain, natively = native.none.total |
        plain, in the browser = browser.none.total |
        quasi-newton, natively = native.quasi-newton.total |
        quasi-newton, in the browser = browser.quasi-newton.total`,
      'The limit of an iteration in the browser: what it moves and computes at least, and the milliseconds that this takes at best on this machine; then how many times as long the iteration takes, and each of its parts beside its own limit:': `
        problem | vertices | MB = limit.millions.bytes |
        million operations, double = limit.millions.double | single = limit.millions.single |
        divisions, roots = limit.millions.divisions | to move = limit.moved |
        to compute = limit.computed | times the larger = limit.times |
        projections = limit.parts.projections.times | closeness = limit.parts.closeness.times |
        smoothness = limit.parts.smoothness.times | global step = limit.parts.global step.times`,
    },
    texts: limitTexts,
  },

  maps: {
    problems: ['D'],
    sizes: [2500, 10_000],
    // The paper's largest map has 35,000 vertices.
    more: [35_000, 100_000],
    repeats: 'cold',
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
    // Larger ones do not converge in a reasonable time.
    sizes: SIZES,
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
        visit | first paint = seen.painted | model there, solved = seen.solved |
        first frame drawn = seen.drawn | kB = seen.kB`,
    },
  },

  exact: {
    problems: ['circles near a net', 'planes near a net', 'rough circles', 'rough planes'],
    sizes: [2500, 10_000, 30_000],
    repeats: 'seconds',
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
        s, natively = seconds.native | theirs / ours = ratio |
        s, in the browser = seconds.browser`,
    },
  },

  peers: {
    cases: ({ sizes, where }) =>
      (where.includes('native') ? peers : []).flatMap((peer) =>
        peer.problems.map((problem) => ({ problem, size: sizes?.[0] ?? peer.vertices, peer })),
      ),
    async measure({ peer, problem: name, size }, on, where) {
      const problem = problemOf(name, size);
      const theirs = await measurePeer(peer, problem, (mesh) => on('native', 'distance', mesh));
      const row = { what: peer.what, equal: peer.equal, ...rowOf(problem), ...theirs };
      const ratio = (ours) => theirs.its?.median / ours.median;
      if (!peer.what) {
        const exact = await repeated('seconds', () => on('native', 'exact', problem));
        return { ...row, exact, ratio: ratio(exact.seconds) };
      }
      const ours = {};
      for (const place of where) ours[place] = await oursIn(place, problem, on);
      return { ...row, ours, ratio: ratio(ours.native) };
    },
    tables: {
      'Other libraries, natively, and what of their problem is equal to ours, in milliseconds:': `
        library | what | equal | vertices | theirs = its | ours, natively = ours.native |
        theirs / ours = ratio | ours in the browser = ours.browser`,
      'Panels made exact, all natively; distances are relative to the size of the mesh:': `
        mesh = surface | panels = kind | library | its way = way |
        its distance = itsDistance | its s = its | our distance = exact.distance |
        our s = exact.seconds | theirs / ours, s = ratio`,
    },
  },
};

/** The time of ours beside a peer: of the plain iteration, or of a map, in the browser not the first. */
async function oursIn(place, problem, on) {
  if (!problem.map) return (await on(place, 'iterations', problem)).none.total;
  if (place === 'browser') return (await on(place, 'maps', problem)).total;
  return (await repeated('cold', () => on(place, 'maps', problem))).cold;
}

/** The formulas of the limits, what the machine can do, and why iterations take longer. */
function limitTexts(rows) {
  const machines = rows.filter(({ limit }) => limit).map(({ limit }) => limit.machine);
  if (!machines.length) return [];
  const best = (of) => number(Math.max(...machines.map((machine) => machine[of])) / 1e6);
  const can = `At best this machine adds or multiplies ${best('double')} billion numbers a second in double and ${best('single')} in single precision, and divides ${best('divisions')}; bytes are read and written at ${best('bytes')} GB a second if they fit its caches.`;
  return [can, formulas(), ...reasons(rows)];
}

/** Returns [title, columns] of the tables of a part. */
export const tablesOf = (name) => Object.entries(parts[name].tables);

/** Returns the paragraphs that follow the tables of a part with these rows. */
export const textsOf = (name, rows) => parts[name].texts?.(rows) ?? [];

/** Returns the cases of a part for some options. */
export function casesOf(name, options) {
  const { cases, problems, sizes, more = [] } = parts[name];
  if (cases) return cases(options);
  const all = options.sizes ?? (options.full ? [...sizes, ...more] : sizes);
  const ascending = all.toSorted((a, b) => a - b);
  const named = problems.filter((one) => !letters.includes(one) || options.problems.includes(one));
  return ascending.flatMap((size) => named.map((problem) => ({ problem, size })));
}

/** Measures a case of a part in its places; returns a row. */
async function measuredIn(name, { problem: letter, size }, where, on) {
  const { repeats, places = ['native', 'browser'] } = parts[name];
  const problem = problemOf(letter, size);
  const row = rowOf(problem);
  for (const place of places.filter((each) => where.includes(each))) {
    const once = () => on(place, name, problem);
    row[place] = repeats ? await repeated(repeats, once) : await once();
  }
  return row;
}

/** Measures a case; returns a row or several. `on` performs a measurement in a place. */
export const measured = (name, one, where, on) =>
  parts[name].measure?.(one, on, where) ?? measuredIn(name, one, where, on);
