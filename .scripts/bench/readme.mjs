// The README's numbers, between two marks.

import { readFileSync, writeFileSync } from 'node:fs';
import { at } from '../project.mjs';
import { Problem } from '../run.mjs';
import { accelerated, machineText, megabytes, number, startTable, table } from './tables.mjs';

/** Between these lines of the README. */
export const marks = [
  '<!-- speed: written by `npm run bench -- --full --readme` -->\n',
  '<!-- end of speed -->\n',
];

/** The tables of the README. */
export function section(results) {
  const { iterations = [], convergence = [], peers = [] } = results;
  const texts = [`${machineText(results.machine)} In the browser, milliseconds, medians:`];
  const rows = iterations.filter(({ where }) => where === 'browser');
  const head = [
    'problem',
    'vertices',
    'accelerator',
    'iteration',
    '90 %',
    'projections',
    'closeness',
  ];
  head.push('global step', 'limit', 'opened', 'constraints changed', 'handle added', 'MB');
  const cells = rows.map((row) => {
    const { step } = row;
    const parts = [step.shape, step.close, step.global].map(({ median }) => median);
    const times = [step.total.median, step.total.p90, ...parts, row.limit, row.setUp.first];
    const edits = [row.change, row.handle].map(number);
    const key = [row.problem, number(row.vertices), accelerated(row.accelerator)];
    return [...key, ...times.map(number), ...edits, megabytes(row.bytes.opened)];
  });
  texts.push(table(head, cells));
  texts.push(
    'The limit is the time to read the nonzeros of the factor twice, as every solve does. "Opened" is from the bytes of the files to the end of the first iteration.',
  );
  const there = convergence.filter(({ where }) => where === 'browser');
  if (there.length) {
    texts.push(
      'Seconds in the browser until the energy is within 1e-2, 1e-4, 1e-6 of the converged one:',
    );
    const key = (row) => [row.problem, number(row.vertices), accelerated(row.accelerator)];
    const within = (row) =>
      row.reached.map((one) =>
        one ? `${number(one.ms / 1e3)} (${number(one.iterations)})` : `> ${number(row.ms / 1e3)}`,
      );
    const wide = ['problem', 'vertices', 'accelerator', '1e-2 (iterations)', '1e-4', '1e-6'];
    texts.push(
      table(
        wide,
        there.map((row) => [...key(row), ...within(row)]),
      ),
    );
  }
  if (results.start) {
    texts.push(
      'The page, with its first model and Run pressed at once, drawn without a graphics card:',
    );
    texts.push(startTable(results.start));
  }
  const compared = peers.filter(({ theirs }) => theirs.ms !== undefined);
  if (compared.length) {
    texts.push('Other libraries, natively, and what of their problem is equal to ours:');
    const its = compared.map(({ peer, version, what, size, equal, theirs, ours }) => {
      const one = ours.find((own) => own.where === 'browser' && own.accelerator !== 'quasi-newton');
      const own = ours.find((own) => own.where === 'native' && own.accelerator !== 'quasi-newton');
      const ms = [theirs.ms, own?.ms, one?.ms].map(number);
      return [`${peer} ${version}`, what, equal, number(size), ...ms];
    });
    texts.push(
      table(
        ['library', 'what', 'equal', 'vertices', 'its ms', 'ours natively', 'in the browser'],
        its,
      ),
    );
  }
  return texts.join('\n\n');
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
