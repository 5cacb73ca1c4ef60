// The benchmark at its smallest size, on the module and the native program that the tests built.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { tablesOf } from '../../.scripts/bench/parts.mjs';
import { benchFolder } from '../../.scripts/bench/problems.mjs';
import { at } from '../../.scripts/project.mjs';

const asked = ['iterations', 'limits', 'maps', 'factors', 'convergence', 'exact'];
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
    assert.doesNotMatch(table.split('\n\n')[1], /–|NaN|undefined/, title);
  }
  const problems = asked.map((part) => rows[part].map(({ problem }) => problem));
  const letters = [...'ABC'];
  assert.deepEqual(problems.slice(0, 5), [letters, letters, ['D'], letters, ['B', 'C']]);
  assert.equal(rows.exact.length, 4);
});

test('an iteration is the longest of its parts, and opening includes one', () => {
  for (const { browser, native, problem } of rows.iterations) {
    for (const { total, shape, close, global } of [browser.none, browser['quasi-newton']])
      assert.ok(total > 0 && total >= Math.max(shape, close, global), problem);
    const { total, opened, change, handle } = browser['quasi-newton'];
    assert.ok(opened > total && change > total && handle > 0, problem);
    assert.ok(Number.isFinite(native.none.total));
  }
  for (const { vertices, browser } of rows.factors) {
    assert.equal(vertices, 400);
    assert.ok(browser['sprs-ldl'] > 0 && browser.supernodal > 0);
  }
});

test('no global step is faster than the machine can move and compute its numbers', () => {
  for (const { limit, vertices } of rows.limits) {
    assert.equal(vertices, 400);
    assert.ok(limit.moved > 0 && limit.computed > 0 && limit.times > 1);
  }
});

test('an accelerated run is near the converged energy in fewer iterations than a plain one', () => {
  for (const { none, 'quasi-newton': quick, anderson } of rows.convergence.map((r) => r.browser)) {
    assert.ok(quick.iterations > 1 && anderson.iterations > 1);
    assert.ok(none.iterations === null || none.iterations > quick.iterations);
  }
});

test('the browser computes the same as the native program, to the last bit', () => {
  const [{ native, browser }] = rows.maps;
  assert.ok(native.cold > 0 && browser.cold > 0 && browser.total > 0);
  assert.equal(browser.eigenvalue, native.eigenvalue);
  for (const { native, browser } of rows.exact) {
    assert.equal(browser.distance, native.distance);
    assert.ok(browser.distance < 1e-10 && browser.misses === 0 && native.seconds > 0);
    assert.ok(browser.seconds > 0 && browser.megabytes > 1);
  }
});
