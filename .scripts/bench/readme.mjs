// The numbers of the README, between two marks.

import { readFileSync, writeFileSync } from 'node:fs';
import { at } from '../project.mjs';
import { Problem } from '../run.mjs';
import { number, table } from './cells.mjs';
import { accelerators } from './problems.mjs';
import { accelerated, machineText, startTable } from './tables.mjs';

/** The lines of the README that enclose them. */
export const marks = [
  '<!-- speed: written by `npm run bench -- --full --readme` -->\n',
  '<!-- end of speed -->\n',
];

const inBrowser = (rows = []) => rows.filter(({ where }) => where === 'browser');

/** The README shows the default accelerator, and peers at one size; `target/bench/` has all. */
const shownAccelerator = 'quasi-newton';
const shownSize = 10_000;

function iterationsText(rows) {
  const shown = rows.filter(({ accelerator }) => accelerator === shownAccelerator);
  if (!shown.length) return [];
  const head = [
    ...['problem', 'vertices', 'iteration', 'of it projections', 'closeness', 'global step'],
    ...['file opened', 'constraints changed', 'handle added'],
  ];
  const cells = shown.map((row) => {
    const { step, problem, vertices, setUp, change, handle } = row;
    const times = ['total', 'shape', 'close', 'global'].map((key) => step[key].median);
    return [problem, ...[vertices, ...times, setUp.first, change, handle].map(number)];
  });
  return [table(head, cells)];
}

function mapsText(rows) {
  if (!rows.length) return [];
  const times = rows.map(({ vertices, cold }) => `${number(cold)} at ${number(vertices)} vertices`);
  return [`Conformal maps (problem D), milliseconds: ${times.join(', ')}.`];
}

/** A row for each problem and size whose converged energy is certain. */
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
  const largest = new Map();
  for (const row of peers) {
    const fits = row.theirs.ms !== undefined && row.size <= shownSize;
    if (fits && row.size > (largest.get(row.what)?.size ?? 0)) largest.set(row.what, row);
  }
  if (!largest.size) return [];
  const cells = [...largest.values()].map(({ peer, version, what, size, equal, theirs, ours }) => {
    const own = ours.find(
      ({ where, accelerator }) => where === 'browser' && accelerator !== shownAccelerator,
    );
    return [`${peer} ${version}`, what, equal, ...[size, theirs.ms, own?.ms].map(number)];
  });
  return [
    'Other libraries, natively, and what of their problem is equal to ours, in milliseconds:',
    table(['library', 'what', 'equal', 'vertices', 'it', 'ours in the browser'], cells),
  ];
}

/** Returns the tables of the README. */
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
