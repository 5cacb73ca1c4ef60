// The benchmark at its smallest size, on the module and the native program that the tests built.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { tablesOf } from '../../.scripts/bench/parts.mjs';
import { benchFolder } from '../../.scripts/bench/problems.mjs';
import { at } from '../../.scripts/project.mjs';

const asked = ['iterations', 'maps', 'factors', 'convergence', 'exact'];
let rows;
let text;

before(() => {
  const words = ['--trial', '--sizes', '400', '--parts', asked.join()];
  const program = at('.scripts', 'bench', 'bench.mjs');
  const { status, stderr, stdout } = spawnSync('node', [program, ...words], { encoding: 'utf8' });
  assert.equal(status, 0, stderr + stdout);
  ({ rows } = JSON.parse(readFileSync(join(benchFolder, 'trial.json'), 'utf8')));
  text = readFileSync(join(benchFolder, 'trial.md'), 'utf8');
});

test('every problem is measured, and every table is filled', () => {
  for (const [title] of asked.flatMap((part) => tablesOf(part))) {
    const [, table] = text.split(title);
    const cells = table.split('\n\n')[1].split('|');
    // B and C have no closeness or smoothness, which their limits leave out.
    const known = cells.filter((cell) => !title.startsWith('The limit') || cell.trim() !== '–');
    for (const cell of known) assert.doesNotMatch(cell, /^ – $|NaN|undefined/, title);
  }
  const problems = asked.map((part) => rows[part].map(({ problem }) => problem));
  const letters = [...'ABC'];
  assert.deepEqual(problems.slice(0, 4), [letters, ['D'], letters, ['B', 'C']]);
  assert.equal(rows.exact.length, 4);
});

test('an iteration is the longest of its parts, and opening includes one', () => {
  for (const { browser, native, problem } of rows.iterations) {
    const medians = (times) =>
      Object.fromEntries(Object.entries(times).map(([name, { median }]) => [name, median]));
    for (const { total, shape, close, smooth, global } of Object.values(browser).map(medians))
      assert.ok(total > 0 && total >= Math.max(shape, close, smooth, global), problem);
    const { total, opened, change, handle } = medians(browser['quasi-newton']);
    assert.ok(opened > total && change > total && handle > 0, problem);
    const { low, high, runs } = native.none.total;
    assert.ok(low <= high && runs === 5);
  }
  for (const { vertices, browser } of rows.factors) {
    assert.equal(vertices, 400);
    assert.ok(browser['sprs-ldl'].median > 0 && browser.supernodal.median > 0);
  }
});

test('no part of an iteration is faster than the machine can move and compute its numbers', () => {
  for (const { limit, problem } of rows.iterations) {
    assert.ok(limit.moved > 0 && limit.computed > 0 && limit.times > 1, problem);
    const { machine, parts } = limit;
    assert.ok(machine.single > machine.double && machine.double > machine.divisions);
    assert.equal('closeness' in parts, problem === 'A');
    for (const part of ['projections', 'global step']) assert.ok(parts[part].times > 1, part);
  }
  assert.match(
    text,
    /^C with 400 vertices takes [\d.]+ times its limit\. Of its time: .*global step \d+ %/m,
  );
});

test('an accelerated run is near the converged energy in fewer iterations than a plain one', () => {
  for (const { none, 'quasi-newton': quick, anderson } of rows.convergence.map((r) => r.browser)) {
    assert.ok(quick.iterations > 1 && anderson.iterations > 1);
    assert.ok(none.iterations === null || none.iterations > quick.iterations);
  }
});

test('the browser computes the same as the native program, to the last bit', () => {
  const [{ native, browser }] = rows.maps;
  assert.ok(native.cold.median > 0 && browser.cold.runs > 1 && browser.total.median > 0);
  assert.equal(browser.eigenvalue, native.eigenvalue);
  for (const { native, browser } of rows.exact) {
    assert.equal(browser.distance, native.distance);
    assert.ok(browser.distance < 1e-10 && browser.misses === 0 && native.seconds.median > 0);
    assert.ok(browser.seconds.median > 0 && browser.megabytes > 1);
  }
});
