// The README's numbers, between two marks.

import { readFileSync, writeFileSync } from 'node:fs';
import { at } from '../project.mjs';
import { Problem } from '../run.mjs';
import { accelerators } from './problems.mjs';
import { accelerated, machineText, megabytes, number, startTable, table } from './tables.mjs';

/** Between these lines of the README. */
export const marks = [
  '<!-- speed: written by `npm run bench -- --full --readme` -->\n',
  '<!-- end of speed -->\n',
];

const inBrowser = (rows = []) => rows.filter(({ where }) => where === 'browser');

/** What a row is of. */
const keyOf = (row) => [row.problem, number(row.vertices), accelerated(row.accelerator)];

function iterationsText(rows) {
  if (!rows.length) return [];
  const head = [
    ...['problem', 'vertices', 'accelerator', 'iteration', '90 %', 'projections', 'closeness'],
    ...['global step', 'limit', 'opened', 'constraints changed', 'handle added', 'MB'],
  ];
  const cells = rows.map((row) => {
    const { step } = row;
    const parts = [step.shape, step.close, step.global].map(({ median }) => median);
    const times = [step.total.median, step.total.p90, ...parts, row.limit, row.setUp.first];
    const edits = [row.change, row.handle].map(number);
    return [...keyOf(row), ...times.map(number), ...edits, megabytes(row.bytes.opened)];
  });
  return [
    table(head, cells),
    'The limit is the time to read the nonzeros of the factor twice, as every solve does. "Opened" is from the bytes of the files to the end of the first iteration.',
  ];
}

function mapsText(rows) {
  if (!rows.length) return [];
  const first = rows.map(({ vertices, cold }) => `${number(cold)} at ${number(vertices)} vertices`);
  const later = rows.map(({ total }) => number(total));
  return [
    `Conformal maps (problem D), milliseconds of the first one: ${first.join(', ')}; of a later one: ${later.join(', ')}.`,
  ];
}

/** A row for each problem and size of which the converged energy is certain. */
function convergenceText(rows) {
  const certain = rows.filter((row) => row.certain);
  if (!certain.length) return [];
  const seconds = (row) => {
    const [, found] = row.reached;
    if (!found) return `> ${number(row.ms / 1e3)}`;
    return `${number(found.ms / 1e3)} (${number(found.iterations)})`;
  };
  const cells = accelerators.map((name) =>
    certain.filter(({ accelerator }) => accelerator === name).map(seconds),
  );
  const keys = certain.filter(({ accelerator }) => accelerator === accelerators[0]);
  return [
    'Seconds (iterations) from the moved handle until the energy is within 1e-4 of the converged one:',
    table(
      ['problem', 'vertices', ...accelerators.map(accelerated)],
      keys.map(({ problem, vertices }, k) => [
        ...[problem, number(vertices)],
        ...cells.map((column) => column[k]),
      ]),
    ),
  ];
}

function startText(start) {
  if (!start) return [];
  return [
    'The page with its first model, drawn without a graphics card:',
    startTable(start),
    'The kB are those until a second and a half later: with what the page keeps for use without a network.',
  ];
}

function peersText(peers = []) {
  const compared = peers.filter(({ theirs }) => theirs.ms !== undefined);
  if (!compared.length) return [];
  const places = ['native', 'browser'].filter((place) =>
    compared.some(({ ours }) => ours.some(({ where }) => where === place)),
  );
  const cells = compared.map(({ peer, version, what, size, equal, theirs, ours }) => {
    const own = (place) =>
      ours.find(({ where, accelerator }) => where === place && accelerator !== 'quasi-newton');
    const ms = [theirs.ms, ...places.map((place) => own(place)?.ms)].map(number);
    return [`${peer} ${version}`, what, equal, number(size), ...ms];
  });
  const names = { native: 'ours natively', browser: 'ours in the browser' };
  const head = ['library', 'what', 'equal', 'vertices', 'its ms'];
  return [
    'Other libraries, natively, and what of their problem is equal to ours:',
    table([...head, ...places.map((place) => names[place])], cells),
  ];
}

/** The tables of the README. */
export function section({ machine, iterations, maps, convergence, start, peers }) {
  return [
    `${machineText(machine)} In the browser, milliseconds, medians:`,
    ...iterationsText(inBrowser(iterations)),
    ...mapsText(inBrowser(maps)),
    ...convergenceText(inBrowser(convergence)),
    ...startText(start),
    ...peersText(peers),
  ].join('\n\n');
}

/** Writes the section into the README. */
export function writeReadme(results) {
  const path = at('README.md');
  const [start, end] = marks;
  const [before, rest] = readFileSync(path, 'utf8').split(start);
  const after = rest?.split(end)[1];
  if (after === undefined) throw new Problem('README.md: the marks of the speed tables are gone');
  writeFileSync(path, `${before}${start}\n${section(results)}\n\n${end}${after}`);
}
