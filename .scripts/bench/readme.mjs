// The five numbers of the README, from the rows of a whole run.

import { readFileSync, writeFileSync } from 'node:fs';
import { Problem } from '../run.mjs';
import { number } from './tables.mjs';

/** The texts of the second column of the README's table, row by row. */
function numbersOf({ iterations, peers, quads, start }) {
  const found = (rows, wanted) => {
    const row = rows.find((one) =>
      Object.entries(wanted).every(([key, value]) => one[key] === value),
    );
    if (!row) throw new Problem(`no measurement of ${Object.values(wanted).join(', ')}`);
    return row;
  };
  const text = ({ median }) => number(median);
  const { none, 'quasi-newton': quick } = found(iterations, {
    problem: 'A',
    vertices: 29_929,
  }).browser;
  const { exact, its, itsDistance } = found(peers, { problem: 'rough circles' });
  const circles = found(peers, { problem: 'circles' });
  // The last rows have the most panels.
  const onVault = quads.filter(({ surface }) => surface === 'vault');
  const [ours, , meshes, flow] = onVault.slice(-4).map((row) => number(row.quads.mean));
  const { drawn } = found(start, { visit: 'first visit' }).seen;
  return [
    `${text(none.total)} ms, accelerated ${text(quick.total)}`,
    `${number(exact.distance)} in ${text(exact.seconds)} s; compas_shapeop ${number(itsDistance)} in ${text(its)} s`,
    `${ours}; quads of Instant Meshes ${meshes}, of QuadriFlow ${flow}`,
    `${text(circles.ours.browser)} ms in the browser, ${text(circles.ours.native)} natively; compas_shapeop ${text(circles.its)}`,
    `${text(drawn)} ms`,
  ];
}

/** Writes the numbers of a run into the README at a path. */
export function writeNumbers(rows, path) {
  const numbers = numbersOf(rows);
  const [before, rest] = readFileSync(path, 'utf8').split(/(?<=^## Five numbers\n)/m);
  const lines = (rest ?? '').split('\n');
  const first = lines.findIndex((line) => line.startsWith('|---')) + 1;
  if (!first) throw new Problem(`${path}: the table of the five numbers is gone`);
  numbers.forEach((text, k) => {
    const cells = lines[first + k].split(' | ');
    lines[first + k] = [cells[0], text, ...cells.slice(2)].join(' | ');
  });
  writeFileSync(path, before + lines.join('\n'));
}
