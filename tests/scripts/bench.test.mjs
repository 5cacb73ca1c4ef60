// The evaluation of the benchmark's measurements.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { marks, optionsOf, page, writeTables } from '../../.scripts/bench/bench.mjs';
import { casesOf, parts, tablesOf } from '../../.scripts/bench/parts.mjs';
import { peers } from '../../.scripts/bench/peers.mjs';
import { problems } from '../../.scripts/bench/problems.mjs';
import { isQuiet, otherLoadText } from '../../.scripts/bench/quiet.mjs';
import { median, medians } from '../../.scripts/bench/statistics.mjs';
import { number, table } from '../../.scripts/bench/tables.mjs';
import { at } from '../../.scripts/project.mjs';

const quiet = { busy: 0.1, stalled: 0.001 };
const busy = { ...quiet, busy: 1.04 };

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

test('numbers keep three significant digits, tiny ones their power of ten', () => {
  const values = [0.01234, 0.43, 1.234, 12.34, 1431.4, 12345, 2e-14, null, undefined];
  const texts = ['0.012', '0.430', '1.23', '12.3', '1,430', '12,345', '2e-14', '–', '–'];
  assert.deepEqual(values.map(number), texts);
});

test('a table has the rows with a measurement, and the columns with a value', () => {
  const columns = 'name | time = a.ms | to the goal = a.goal | nothing';
  const rows = [
    { name: 'one', a: { ms: 1.25, goal: { seconds: 0.5, iterations: 12 } } },
    { name: 'two', a: { goal: { seconds: 3.01, iterations: null } } },
    { name: 'failed' },
  ];
  assert.equal(
    table(columns, rows),
    '| name | time | to the goal |\n|---|---|---|\n| one | 1.25 | 0.500 (12) |\n| two | – | > 3.01 |',
  );
  assert.equal(table('name | other = b.ms', rows), null);
});

test('command line options are checked', () => {
  assert.throws(() => optionsOf(['--sizes', 'many']), /--sizes many/);
  assert.throws(() => optionsOf(['--problems', 'A,Q']), /--problems Q.* of A,B,C,D,E/s);
  assert.throws(() => optionsOf(['--fast']), /--fast/);
  assert.throws(() => optionsOf(['--trial', '--write']), /--write/);
  const { parts: named } = optionsOf([]);
  assert.ok(named.includes('start') && !named.includes('peers'));
  assert.ok(optionsOf(['--full', '--write']).parts.includes('peers'));
});

test('a part measures its problems in the sizes asked for', () => {
  const casesFor = (...words) => casesOf('iterations', optionsOf(words));
  const problems = (cases) => cases.map(({ problem }) => problem).join('');
  assert.equal(problems(casesFor('--sizes', '900')), 'ABC');
  assert.deepEqual(casesFor('--sizes', '900', '--problems', 'D,E'), [{ problem: 'E', size: 900 }]);
  assert.equal(problems(casesFor()), 'ABCABC');
  assert.equal(casesFor('--full').at(-1).size, 100_000);
});

test('peers get problems that exist', () => {
  for (const name of peers.flatMap((peer) => peer.problems)) assert.ok(problems[name], name);
});

test('a machine is not quiet if others compute, or take our core', () => {
  assert.ok(isQuiet(quiet));
  assert.ok(!isQuiet(busy) && !isQuiet({ ...quiet, stalled: 0.1 }));
  assert.match(otherLoadText(quiet, busy), /not quiet.* 0\.1 and 1\.0 cores/);
});

/** Writes results of a machine with some other load into an empty page; returns what it is then. */
function written(...moments) {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-bench-'));
  const path = join(folder, 'page.md');
  const iterations = [
    {
      ...{ problem: 'A', vertices: 2500 },
      browser: { 'quasi-newton': { total: 1.25 } },
      native: { none: { total: 77 } },
    },
  ];
  writeFileSync(path, `# Title\n${marks.join('')}The end.\n`);
  try {
    writeTables({ machine: 'Here.', moments, rows: { iterations } }, path);
    return readFileSync(path, 'utf8');
  } catch ({ message }) {
    return { message, text: readFileSync(path, 'utf8') };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('the tables are written between the marks', () => {
  const text = written(quiet, quiet);
  assert.match(
    text,
    /^# Title\n<!-- speed.*Here\..*\| A \| 2,500 \| 1\.25 \|.*end of.*The end\.\n$/s,
  );
  assert.match(text, /\| A \| 2,500 \| 77 \|/);
});

test('nothing is written if the machine was not quiet, before or after', () => {
  for (const moments of [
    [quiet, busy],
    [busy, quiet],
  ]) {
    const { message, text } = written(...moments);
    assert.match(message, /not quiet.*tables are not written/);
    assert.equal(text, `# Title\n${marks.join('')}The end.\n`);
  }
});

test('the documentation has the tables that the benchmark writes', () => {
  const text = readFileSync(at(page), 'utf8');
  for (const mark of marks) assert.equal(text.split(mark).length, 2, mark);
  const section = text.split(marks[0])[1].split(marks[1])[0];
  for (const [title] of Object.keys(parts).flatMap((name) => tablesOf(name)))
    assert.ok(section.includes(`\n${title}\n`), title);
});
