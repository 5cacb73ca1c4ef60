// Tables and target numbers of hard constraints.

import { megabytes, missing, number, table } from '../cells.mjs';
import { isOfSize, median } from '../statistics.mjs';
import { titleOf } from './problems.mjs';

const tiny = (value) => (value === null || value === undefined ? missing : value.toExponential(0));
const asked = ({ kind, within }) => `${kind}, ${within === null ? 'exact' : `within ${within}`}`;

/** One row per problem and place: seconds, and distances relative to the size. */
export function exactTable(rows) {
  const head = ['mesh', 'vertices', 'panels', 'where', 'soft s', 's', 'iterations'];
  head.push('block factors', 'distance', 'moved', 'shortest edge', 'unmet', 'MB of wasm');
  return table(
    head,
    rows.map((row) => [
      titleOf(row.surface),
      ...[number(row.vertices), asked(row), row.where],
      ...[row.soft, row.seconds, row.iterations, row.blockFactors].map(number),
      ...[tiny(row.distance), number(row.moved), number(row.shortestEdge), row.unmet],
      megabytes(row.bytes ?? undefined),
    ]),
  );
}

/** Variations of exact shapes: milliseconds, and the worst distance of a step over the size. */
export function variationTable(rows) {
  const head = ['mesh', 'vertices', 'panels', 'where', 'modes', 'until they are found'];
  head.push('a step', 'the slowest step', 'whole steps', 'worst distance');
  return table(
    head,
    rows
      .filter(({ varied }) => varied)
      .map(({ varied: { modes, steps }, ...row }) => [
        ...[titleOf(row.surface), number(row.vertices), row.kind, row.where, steps.length],
        ...[modes, median(steps.map(({ ms }) => ms)), Math.max(...steps.map(({ ms }) => ms))].map(
          number,
        ),
        ...[steps.filter(({ part }) => part === 1).length],
        ...[tiny(Math.max(...steps.map(({ distance }) => distance)))],
      ]),
  );
}

/** Results of other libraries beside ours: in the browser, or natively if that was not measured. */
export function exactPeerTable(peers, ours) {
  const head = ['mesh', 'vertices', 'panels', 'library', 'its way', 'its distance', 'its s'];
  head.push('our distance', 'our s');
  return table(
    head,
    peers.map(({ peer, version, way, distance, seconds, reason, ...row }) => {
      const is = (one) =>
        ['surface', 'kind', 'vertices', 'within'].every((key) => one[key] === row[key]);
      const all = ours.filter(is);
      const own = all.find(({ where }) => where === 'browser') ?? all[0];
      return [
        ...[titleOf(row.surface), number(row.vertices), row.kind],
        ...[version ? `${peer} ${version}` : peer, way],
        ...[reason ?? tiny(distance), number(seconds), tiny(own?.distance), number(own?.seconds)],
      ];
    }),
  );
}

/** Target seconds from the soft solution, by the number of vertices. */
const SECONDS = {
  net: { 2500: 0.3, 10_000: 1, 30_000: 4 },
  rough: { 2500: 1.2, 10_000: 5, 30_000: 20 },
};
const inBrowser = (rows, surface, kind, within, size) =>
  rows?.find(
    (row) =>
      row.where === 'browser' &&
      row.surface === surface &&
      row.kind === kind &&
      (row.within === null) === (within === null) &&
      isOfSize(row.vertices, size),
  );

const title = (surface, size) => `${titleOf(surface)}, ${number(Number(size))} vertices`;

export const exactTargets = [
  ...Object.entries(SECONDS).flatMap(([surface, bySize]) =>
    Object.entries(bySize).flatMap(([size, most]) =>
      ['circle', 'plane'].map((kind) => ({
        name: `${title(surface, size)}: seconds until every ${kind} is exact`,
        most,
        find: ({ exact }) => inBrowser(exact, surface, kind, null, Number(size))?.seconds,
      })),
    ),
  ),
  ...['net', 'rough'].map((surface) => ({
    name: `${title(surface, 10_000)}: seconds until circles are within a thousandth of the size`,
    most: 0.7,
    find: ({ exact }) => inBrowser(exact, surface, 'circle', 1e-3, 10_000)?.seconds,
  })),
  ...['circle', 'plane'].flatMap((kind) => [
    {
      name: `${title('net', 2500)}, ${kind}: milliseconds until eight variations are found`,
      most: 1000,
      find: ({ exact }) => inBrowser(exact, 'net', kind, null, 2500)?.varied?.modes,
    },
    {
      name: `${title('net', 2500)}, ${kind}: milliseconds of a step of a fiftieth of the size`,
      most: 50,
      find: ({ exact }) => {
        const steps = inBrowser(exact, 'net', kind, null, 2500)?.varied?.steps;
        return steps && median(steps.map(({ ms }) => ms));
      },
    },
  ]),
  ...['circle', 'plane'].map((kind) => ({
    name: `${title('net', 30_000)}, ${kind}: MB of wasm memory`,
    most: 400,
    find: ({ exact }) => {
      const bytes = inBrowser(exact, 'net', kind, null, 30_000)?.bytes;
      return bytes && bytes / 1e6;
    },
  })),
];
