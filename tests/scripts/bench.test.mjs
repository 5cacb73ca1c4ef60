// The evaluation of the benchmark's measurements.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { number } from '../../.scripts/bench/cells.mjs';
import { optionsOf } from '../../.scripts/bench/options.mjs';
import { marks, section } from '../../.scripts/bench/readme.mjs';
import { growth, reached, spread } from '../../.scripts/bench/statistics.mjs';
import { firstToConverge } from '../../.scripts/bench/tables.mjs';
import { targetRows } from '../../.scripts/bench/targets.mjs';
import { at } from '../../.scripts/project.mjs';

test('a spread has the minimum, the median and the 10 % and 90 % quantiles', () => {
  const values = Array.from({ length: 11 }, (_, k) => 10 - k);
  assert.deepEqual(spread(values), { least: 0, median: 5, p10: 1, p90: 9 });
  assert.deepEqual(spread([]), { least: null, median: null, p10: null, p90: null });
});

test('an energy counts as reached at the first iteration that is as close', () => {
  const run = { energies: [9, 1.5, 1.009, 1.00001], steps: [3, 4, 5] };
  const [near, nearer, nearest] = reached(run, 1, [1e-2, 1e-4, 1e-6]);
  assert.deepEqual(
    [near, nearer, nearest],
    [{ iterations: 2, ms: 7 }, { iterations: 3, ms: 12 }, null],
  );
});

test('n log n growth has a ratio of one', () => {
  const cost = (n) => 3 * n * Math.log(n);
  const { exponent, overLinearithmic } = growth([100, cost(100)], [10_000, cost(10_000)]);
  assert.ok(Math.abs(overLinearithmic - 1) < 1e-12);
  assert.ok(exponent > 1 && exponent < 1.2);
});

test('numbers keep three significant digits', () => {
  assert.deepEqual([0.01234, 1.234, 12.34, 123.4, 12345, null].map(number), [
    '0.012',
    '1.23',
    '12.3',
    '123',
    '12,345',
    '–',
  ]);
});

test('command line options are checked', () => {
  assert.throws(() => optionsOf(['--sizes', 'many']), /--sizes many/);
  assert.throws(() => optionsOf(['--problems', 'A,Q']), /Q: expected some of A, B, C, D/);
  assert.throws(() => optionsOf(['--fast']), /--fast/);
  const { sizes, parts } = optionsOf(['--peers']);
  assert.deepEqual(sizes, [2500, 10_000]);
  assert.ok(parts.has('peers') && !parts.has('operators'));
});

test('the accelerator that converges first is named', () => {
  const run = (accelerator, vertices, ms) => ({
    ...{ problem: 'B', vertices, where: 'browser', accelerator },
    reached: [{ iterations: 1, ms: 1 }, ms && { iterations: 2, ms }, null],
  });
  const rows = [run('none', 400, null), run('anderson', 400, 3), run('quasi-newton', 400, 2)];
  const text = firstToConverge([...rows, run('none', 900, null)]);
  assert.match(text, /B, 400 vertices, browser: quasi-newton/);
  assert.match(text, /B, 900 vertices, browser: none of them in time/);
});

const entry = (problem, vertices, ms) => ({
  problem,
  vertices,
  where: 'browser',
  accelerator: 'quasi-newton',
  step: Object.fromEntries(
    ['total', 'shape', 'close', 'smooth', 'global'].map((key) => [key, { median: ms, p90: ms }]),
  ),
  setUp: { first: 9 },
  limit: 0.5,
  bytes: { opened: 2e6 },
});

test('a target is met or missed by its measurement, and left out without one', () => {
  const rows = targetRows({ iterations: [entry('A', 10_000, 1.4), entry('B', 10_000, 1.4)] });
  const perIteration = rows.filter(({ name }) => name.endsWith('ms per iteration'));
  assert.deepEqual(
    perIteration.map(({ name, met }) => [name[0], met]),
    [
      ['A', true],
      ['B', false],
    ],
  );
  assert.deepEqual(targetRows({}), []);
});

test('the README has a place for the numbers, which are those of the browser', () => {
  const readme = readFileSync(at('README.md'), 'utf8');
  for (const mark of marks) assert.equal(readme.split(mark).length, 2, mark);
  const native = { ...entry('A', 2500, 77), where: 'native' };
  const text = section({ machine: { cores: 2 }, iterations: [native, entry('A', 2500, 1.25)] });
  assert.match(text, /\| A \| 2,500 \| 1\.25 \|/);
  assert.doesNotMatch(text, /77/);
});

test('the README compares accelerators only if the converged energy is certain', () => {
  const run = (vertices, accelerator, found, certain = true) => {
    const reached = [null, found && { ms: 500, iterations: found }, null];
    return { problem: 'B', vertices, accelerator, where: 'browser', ms: 3000, reached, certain };
  };
  const of = (...row) =>
    ['none', 'quasi-newton', 'anderson'].map((name, k) => run(row[0], name, row[k + 1]));
  const unsure = of(900, 1, 2, 3).map((row) => ({ ...row, certain: false }));
  const text = section({
    machine: { cores: 2 },
    convergence: [...of(400, null, 12, 34), ...unsure],
  });
  assert.match(text, /\| B \| 400 \| > 3 \| 0\.500 \(12\) \| 0\.500 \(34\) \|/);
  assert.doesNotMatch(text, /900/);
});
