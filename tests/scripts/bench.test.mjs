// The evaluation of the benchmark's measurements.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { markdown, marks, optionsOf } from '../../.scripts/bench/bench.mjs';
import { parts } from '../../.scripts/bench/parts.mjs';
import { peers } from '../../.scripts/bench/peers.mjs';
import { problems } from '../../.scripts/bench/problems.mjs';
import { isQuiet, unrestText } from '../../.scripts/bench/quiet.mjs';
import { iterationsUntil, median, medians } from '../../.scripts/bench/statistics.mjs';
import { number, table } from '../../.scripts/bench/tables.mjs';
import { at } from '../../.scripts/project.mjs';

const quiet = { busy: 0.1, stalled: 0.001 };
const machine = { versions: ['Chromium 1'], before: quiet, after: quiet };

test('medians are those of the sorted values, of each property', () => {
  assert.equal(median([10, 9, 1, 2, 3]), 3);
  assert.equal(median([]), null);
  const all = [
    { a: 1, b: 9 },
    { a: 3, b: 7 },
    { a: 2, b: 8 },
  ];
  assert.deepEqual(medians(all), { a: 2, b: 8 });
});

test('an energy counts as reached at the first iteration that is as close', () => {
  const energies = [9, 1.5, 1.009, 1.00001];
  assert.equal(iterationsUntil(1.01, energies), 2);
  assert.equal(iterationsUntil(1, energies), null);
});

test('numbers keep three significant digits, tiny ones their power of ten', () => {
  const values = [0.01234, 1.234, 12.34, 123.4, 12345, 2e-14, null, undefined];
  const texts = ['0.012', '1.23', '12.3', '123', '12,345', '2e-14', '–', '–'];
  assert.deepEqual(values.map(number), texts);
});

test('a table has the rows with a value, and the columns with one', () => {
  const columns = 'name | time = a.ms | to the goal = a.goal | nothing';
  const rows = [
    { name: 'one', a: { ms: 1.25, goal: { seconds: 0.5, iterations: 12 } } },
    { name: 'two', a: { goal: { seconds: 3.01, iterations: null } } },
    { name: 'failed' },
  ];
  assert.equal(
    table({ has: 'a', columns }, rows),
    '| name | time | to the goal |\n|---|---|---|\n| one | 1.25 | 0.500 (12) |\n| two | – | > 3.01 |',
  );
  assert.equal(table({ has: 'b', columns }, rows), null);
});

test('command line options are checked', () => {
  assert.throws(() => optionsOf(['--sizes', 'many']), /--sizes many/);
  assert.throws(() => optionsOf(['--problems', 'A,Q']), /Q: expected some of A, B, C, D/);
  assert.throws(() => optionsOf(['--fast']), /--fast/);
  const { sizes, parts, meshes } = optionsOf(['roof.obj']);
  assert.deepEqual(sizes, [2500, 10_000]);
  assert.ok(parts.includes('start') && !parts.includes('peers'));
  assert.deepEqual(meshes, ['roof.obj']);
});

test('peers get problems that exist', () => {
  for (const name of peers.flatMap((peer) => peer.problems)) assert.ok(problems[name], name);
});

test('a machine is not quiet if others compute, or take our core', () => {
  assert.ok(isQuiet(quiet));
  assert.ok(!isQuiet({ ...quiet, busy: 1 }) && !isQuiet({ ...quiet, stalled: 0.1 }));
  assert.match(unrestText(quiet, { busy: 1.04, stalled: 0 }), /not quiet.* 0\.1 and 1\.0 cores/);
});

test('the README has the tables that the benchmark writes, and only those of the browser', () => {
  const readme = readFileSync(at('README.md'), 'utf8');
  for (const mark of marks) assert.equal(readme.split(mark).length, 2, mark);
  const section = readme.split(marks[0])[1].split(marks[1])[0];
  const shown = Object.values(parts).flatMap(({ tables }) => tables.filter((one) => one.readme));
  for (const { title } of shown) assert.ok(section.includes(`\n${title}\n`), title);
  const iterations = [
    {
      ...{ problem: 'A', vertices: 2500, iterated: true },
      browser: { 'quasi-newton': { total: 1.25 } },
      native: { none: { total: 77 } },
    },
  ];
  const text = markdown({ machine, rows: { iterations } }, { readme: true });
  assert.match(text, /\| A \| 2,500 \| 1\.25 \|/);
  assert.doesNotMatch(text, /77/);
});
