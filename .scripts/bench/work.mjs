// What an iteration with the default accelerator moves and computes at least, counted from sizes,
// beside what the machine can do at best in the same time.

import { sum } from './statistics.mjs';
import { number, table } from './tables.mjs';

/** Pairs of steps that the accelerator keeps: the default of the solver. */
const PAIRS = 5;

/**
 * The closed form of a kind: operations, then divisions and roots, of a constraint and of each of its
 * points; and bytes of rest points. `tests/constraint/operations.rs` counts them.
 */
export const kernels = {
  circle: { operations: [203, 69], divisions: [9, 2], rest: 0 },
  rigid: { operations: [267, 45], divisions: [5, 0], rest: 24 },
};

/**
 * The work of each part of an iteration as multiples of sizes: `n` vertices, `e` ends of edges, `m`
 * constraints of `p` points together, `z` numbers of the factor. A row of a vector has 32 bytes, in
 * single precision 16. `bytes` are those of what a part reads or writes, once for each pass over it;
 * `double` and `single` are additions and multiplications for three coordinates.
 */
function partsOf(kind) {
  const { operations, divisions, rest } = kernels[kind];
  return {
    // Reads positions and nodes, adds to the gradient; centres, projects, centres again, and subtracts.
    projections: {
      bytes: { n: 96, p: 4 + rest },
      double: { m: operations[0] + 4, p: operations[1] + 35 },
      divisions: { m: divisions[0], p: divisions[1] },
    },
    // The triangle of each vertex with the region in which it stays the closest: 192 bytes.
    closeness: { bytes: { n: 304 }, double: { n: 64 } },
    // Sums over neighbours, of positions and once more of the sums.
    smoothness: { bytes: { n: 168, e: 24 }, double: { n: 12, e: 18 } },
    // The last step, two passes over the pairs, and both sweeps over the factor between them.
    'global step': {
      bytes: { n: 388 + 64 * PAIRS, z: 8 },
      double: { n: 21 },
      single: { n: 15 + 30 * PAIRS, z: 12 },
    },
    // The gradient is cleared, and positions are looked through for what is no number.
    'the rest': { bytes: { n: 64 } },
  };
}

/** The names in `Solver.report()` of the measured parts; what they leave of the total is the rest. */
const measuredAs = {
  projections: 'shape',
  closeness: 'close',
  smoothness: 'smooth',
  'global step': 'global',
};

/** The kind of constraint of a problem, and its sizes; null if there is no formula for all its parts. */
export function sizesOf({ scene, faces, vertices: n }, z) {
  const { constraints = [], closeness, weights } = JSON.parse(scene ?? '{}');
  if (constraints.length !== 1 || closeness.boundary) return null;
  const [{ kind, on }] = constraints;
  const corners = faces.flat().length;
  const sides = faces.flatMap((face) =>
    face.map((a, k) => [a, face[(k + 1) % face.length]].sort()),
  );
  const e = 2 * new Set(sides.map(String)).size;
  const [m, p] = on === 'faces' ? [faces.length, corners] : [n, n + e];
  const without = [
    ...(closeness.to === 'surface' ? [] : ['closeness']),
    ...(weights.smooth > 0 ? [] : ['smoothness']),
  ];
  return { kind, sizes: { n, e, m, p, z }, without };
}

/** The work of each part for these sizes: by part the `bytes`, `double`, `single` and `divisions`. */
export function workOf({ kind, sizes, without }) {
  const counted = (form = {}) => sum(Object.entries(form).map(([size, k]) => k * sizes[size]));
  const parts = Object.entries(partsOf(kind)).filter(([part]) => !without.includes(part));
  const forms = ['bytes', 'double', 'single', 'divisions'];
  return Object.fromEntries(
    parts.map(([part, work]) => [
      part,
      Object.fromEntries(forms.map((form) => [form, counted(work[form])])),
    ]),
  );
}

/** What the machine does in a millisecond, measured once. */
let rates;

/** The milliseconds to move and to compute what a part has. Divisions have a unit of their own. */
const limitOf = (work, { bytes, single, double, divisions }) => ({
  moved: work.bytes / bytes,
  computed: Math.max(work.single / single + work.double / double, work.divisions / divisions),
});

/** Measures the limits of a problem beside the measured times of its iteration in the browser. */
export async function measureLimits(problem, times, on) {
  const known = sizesOf(problem, await on('native', 'nonzeros', problem));
  if (!known) return undefined;
  const works = workOf(known);
  const forms = Object.keys(Object.values(works)[0]);
  const all = Object.fromEntries(
    forms.map((form) => [form, sum(Object.values(works).map((work) => work[form]))]),
  );
  rates ??= await on('browser', 'rates', {});
  const machine = { ...rates, bytes: await on('browser', 'bytesPerMs', { bytes: all.bytes }) };
  const total = times.total.median;
  const own = (part) => times[measuredAs[part]]?.median;
  const rest = total - sum(Object.keys(measuredAs).map(own));
  const parts = {};
  for (const [part, work] of Object.entries(works)) {
    const { moved, computed } = limitOf(work, machine);
    const ms = own(part) ?? Math.max(0, rest);
    parts[part] = { share: ms / total, times: ms / Math.max(moved, computed) };
  }
  const { moved, computed } = limitOf(all, machine);
  const millions = Object.fromEntries(forms.map((form) => [form, all[form] / 1e6]));
  return { machine, millions, moved, computed, times: total / Math.max(moved, computed), parts };
}

/** A linear form as text, such as `96 n + 4 p`. */
const formText = (form = {}) =>
  Object.entries(form)
    .filter(([, k]) => k)
    .map(([size, k]) => `${k} ${size}`)
    .join(' + ') || '–';

/** The formulas as a table, the projections for each kind. */
export function formulas() {
  // Only projections depend on the kind.
  const others = Object.entries(partsOf('circle')).filter(([part]) => part !== 'projections');
  const rows = [
    ...Object.keys(kernels).map((kind) => [`projections, ${kind}`, partsOf(kind).projections]),
    ...others,
  ].map(([part, { bytes, double, single, divisions }]) => ({
    ...{ part, of: { bytes: formText(bytes), double: formText(double) } },
    ...{ also: { single: formText(single), divisions: formText(divisions) } },
  }));
  const columns = `part | bytes = of.bytes | operations, double = of.double | single = also.single | divisions, roots = also.divisions`;
  return table(columns, rows);
}

/** The least and the greatest of some numbers as text. */
function range(values, text) {
  const [least, most] = [Math.min(...values), Math.max(...values)].map(text);
  return least === most ? least : `${least} to ${most}`;
}

/** Says for each problem that is above twice its limit, in which parts its time is. */
export function reasons(rows) {
  const limited = rows.filter(({ limit }) => limit?.times > 2);
  return [...new Set(limited.map(({ problem }) => problem))].map((name) => {
    const own = limited.filter(({ problem }) => problem === name);
    const limits = own.map(({ limit }) => limit);
    const named = Object.keys(limits[0].parts).filter((part) => part in measuredAs);
    const shares = named.map((part) => {
      const share = limits.map(({ parts }) => parts[part].share);
      const times = limits.map(({ parts }) => parts[part].times);
      const percent = range(share, (value) => (100 * value).toFixed(0));
      const text = `${part} ${percent} % (${range(times, number)} times its own limit)`;
      return { mean: sum(share), text };
    });
    const texts = shares.toSorted((a, b) => b.mean - a.mean).map(({ text }) => text);
    const [sizes, times] = [
      own.map(({ vertices }) => vertices),
      limits.map((limit) => limit.times),
    ];
    return `${name} with ${sizes.map(number).join(', ')} vertices takes ${range(times, number)} times its limit. Of its time: ${texts.join(', ')}.`;
  });
}
