// Targets in the browser on a quiet machine with two cores, one of which is used.

import { exactTargets } from './exact/tables.mjs';
import { growth, isOfSize } from './statistics.mjs';

const inBrowser = (rows, problem, size, accelerator = 'quasi-newton') =>
  rows?.find(
    (row) =>
      row.where === 'browser' &&
      row.problem === problem &&
      row.accelerator === accelerator &&
      isOfSize(row.vertices, size),
  );

const plainAt30000 = (rows, problem, place) =>
  rows?.find(
    ({ where, problem: letter, accelerator, vertices }) =>
      where === place && letter === problem && accelerator === 'none' && isOfSize(vertices, 30_000),
  );

const perIteration = (problem, size, most) => ({
  name: `${problem} at ${size.toLocaleString('en')}: ms per iteration`,
  most,
  find: ({ iterations }) => inBrowser(iterations, problem, size)?.step.total.median,
});

const natively = (problem, most) => ({
  name: `${problem} at 30,000, plain, natively: ms per iteration`,
  most,
  find: ({ iterations }) => plainAt30000(iterations, problem, 'native')?.step.total.median,
});

/** The first map of a visit, since a user rarely computes more than one. */
const firstMap = (vertices, most) => ({
  name: `D at ${vertices.toLocaleString('en')}: seconds of the first conformal map`,
  most,
  find: ({ maps }) => {
    const isIt = (row) => row.problem === 'D' && row.where === 'browser';
    const ms = maps?.find((row) => isIt(row) && isOfSize(row.vertices, vertices))?.cold;
    return ms === undefined ? undefined : ms / 1e3;
  },
});

const changed = (problem, most) => ({
  name: `${problem} at 30,000: ms from changed constraints to the first iteration`,
  most,
  find: ({ iterations }) => inBrowser(iterations, problem, 30_000)?.change,
});

const targets = [
  ...exactTargets,
  perIteration('A', 10_000, 1.5),
  perIteration('A', 30_000, 6),
  perIteration('A', 100_000, 30),
  perIteration('B', 10_000, 1.2),
  natively('A', 6),
  natively('E', 8),
  {
    name: 'A at 30,000, plain: the browser over native',
    most: 1.2,
    find: ({ iterations }) => {
      const of = (where) => plainAt30000(iterations, 'A', where)?.step.total.median;
      return of('browser') / of('native') || undefined;
    },
  },
  changed('A', 120),
  changed('B', 60),
  firstMap(35_000, 0.7),
  ...['A', 'B'].map((problem) => ({
    name: `${problem} at 30,000: ms to add a handle`,
    most: 2,
    find: ({ iterations }) => inBrowser(iterations, problem, 30_000)?.handle,
  })),
  {
    name: 'B at 10,000: seconds to 1e-4 from a large handle move',
    most: 0.8,
    find: ({ convergence }) => {
      const ms = inBrowser(convergence, 'B', 10_000)?.reached[1]?.ms;
      return ms === undefined ? undefined : ms / 1e3;
    },
  },
  {
    name: 'A at 30,000: one solve over reading the factor twice',
    most: 4,
    find: ({ iterations }) => {
      const row = inBrowser(iterations, 'A', 30_000);
      return row && row.limit !== null ? row.fresh.global.median / row.limit : undefined;
    },
  },
  {
    name: 'A at 10,000: closeness as a part of the iteration',
    most: 1 / 3,
    find: ({ iterations }) => {
      const step = inBrowser(iterations, 'A', 10_000)?.step;
      return step && step.close.median / step.total.median;
    },
  },
  {
    name: 'A at 100,000: MB of wasm memory',
    most: 400,
    find: ({ iterations }) => {
      const bytes = inBrowser(iterations, 'A', 100_000)?.bytes;
      return bytes && bytes.opened / 1e6;
    },
  },
  {
    name: 'ten models in turn: growth of memory, in models',
    most: 1,
    find: ({ models }) =>
      // Memory grows in pages, which hide the growth of a small model.
      models?.vertices >= 2500
        ? (models.opened.at(-1) - models.opened[0]) / (models.opened[0] - models.empty)
        : undefined,
  },
  ...['A', 'B', 'C'].map((problem) => ({
    name: `${problem}: growth from 2,500 to 100,000 over n log n`,
    most: 1,
    find: ({ iterations }) => {
      const ends = [2500, 100_000].map((size) => inBrowser(iterations, problem, size));
      if (!ends.every(Boolean)) return undefined;
      return growth(...ends.map((row) => [row.vertices, row.step.total.median])).overLinearithmic;
    },
  })),
  {
    name: 'all of the look, by software: times a frame without it',
    most: 4 / 3,
    find: ({ look }) => look?.at(-1)?.ratio,
  },
  {
    name: 'compas_shapeop over ours in the browser, at the largest size',
    least: 5,
    find: ({ peers }) => {
      const rows = peers?.filter(({ call, theirs }) => call === 'compas_circles' && theirs.ms);
      const last = rows?.at(-1);
      const ours = last?.ours.find((one) => one.where === 'browser' && one.accelerator === 'none');
      return ours && last.theirs.ms / ours.ms;
    },
  },
];

/** Returns the targets with a measured value: { name, target, found, met }. */
export function targetRows(results) {
  return targets.flatMap(({ name, most, least, find }) => {
    const found = find(results);
    if (found === undefined || found === null) return [];
    const target = most === undefined ? `at least ${least}` : `at most ${+most.toFixed(2)}`;
    return [{ name, target, found, met: most === undefined ? found >= least : found <= most }];
  });
}
