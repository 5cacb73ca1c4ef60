// The benchmark builds and runs at its smallest size. It measures the result of `npm run build`,
// which must run first.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { benchFolder } from '../../.scripts/bench/problems.mjs';
import { at } from '../../.scripts/project.mjs';

let results;
let text;

before(() => {
  const words = ['--trial', '--sizes', '400', '--limit', '0.5'];
  const asked = ['--parts', 'iterations,factors,convergence,memory,build,exact'];
  const { status, stderr } = spawnSync(
    'node',
    [at('.scripts', 'bench', 'bench.mjs'), ...words, ...asked],
    {
      encoding: 'utf8',
    },
  );
  assert.equal(status, 0, stderr);
  results = JSON.parse(readFileSync(join(benchFolder, 'trial.json'), 'utf8'));
  text = readFileSync(join(benchFolder, 'trial.md'), 'utf8');
});

test('every problem is measured natively and in the browser', () => {
  const keys = results.iterations.map(({ problem, where }) => `${problem} ${where}`);
  const expected = ['A', 'B', 'C'].flatMap((problem) => [
    `${problem} browser`,
    `${problem} native`,
  ]);
  assert.deepEqual([...new Set(keys)].sort(), expected);
  for (const row of results.iterations) {
    const { step, setUp, bytes, where } = row;
    assert.ok(step.total.p10 > 0 && step.total.p10 <= step.total.p90, JSON.stringify(step));
    assert.ok(step.total.median >= step.global.median);
    assert.ok(setUp.first >= setUp.total && setUp.factor > 0);
    assert.ok(row.nonzeros > row.vertices);
    assert.ok(where === 'native' ? bytes === null : bytes.opened > 1e6);
  }
  assert.match(text, /\| A \| 400 \| browser \| quasi-newton \|/);
});

test('both factorisations are timed from changed constraints to the first iteration', () => {
  assert.deepEqual(
    results.factors.map(({ problem }) => problem),
    ['A', 'B', 'C'],
  );
  for (const { of, unknowns } of results.factors) {
    assert.equal(unknowns, 400);
    for (const name of ['sprs-ldl', 'supernodal']) {
      assert.ok(
        of[name].change.median > of[name].factor.median && of[name].factor.median > 0,
        name,
      );
    }
  }
  assert.match(text, /Both numeric factors/);
});

test('the browser converges like the native program, to the last bit of the energy', () => {
  const { convergence } = results;
  const inBrowser = convergence.filter(({ where }) => where === 'browser');
  assert.equal(inBrowser.length, 6);
  for (const row of inBrowser) {
    const same = (other) => other.problem === row.problem && other.accelerator === row.accelerator;
    const native = convergence.find((other) => other.where === 'native' && same(other));
    assert.equal(row.start, native.start);
    row.reached.forEach((one, k) => {
      if (one && native.reached[k]) assert.equal(one.iterations, native.reached[k].iterations);
    });
  }
  const quick = inBrowser.filter(({ accelerator }) => accelerator !== 'none');
  assert.ok(quick.some(({ reached }) => reached[0]?.iterations > 1));
});

test('the flat map in the browser equals the native one to the last bit', () => {
  const [native, browser] = ['native', 'browser'].map((place) =>
    results.maps.find(({ where }) => where === place),
  );
  assert.ok(native.total > 0 && browser.total > 0 && browser.factor > 0);
  assert.equal(browser.eigenvalue, native.eigenvalue);
  assert.ok(browser.cold > 0 && browser.bytes > 1e6);
  assert.match(text, /\| D \| 400 \| browser \|/);
});

test('memory is measured while ten models are opened in turn', () => {
  const { empty, opened } = results.models;
  assert.equal(opened.length, 10);
  assert.ok(empty > 0 && opened.every((bytes, k) => bytes >= (opened[k - 1] ?? empty)));
});

test('parts are measured natively and in WebAssembly', () => {
  assert.deepEqual(
    results.parts.map(({ panels, where }) => [panels, where]),
    [
      [100, 'native'],
      [100, 'WebAssembly'],
    ],
  );
  for (const { build, axes, distance, sheets, files } of results.parts)
    for (const time of [build, axes, distance, sheets, files]) assert.ok(time > 0);
  assert.match(text, /## Parts and sheets/);
});

test('native and browser runs meet hard constraints with the same numbers', () => {
  const of = (place) => results.exact.filter(({ where }) => where === place);
  const [native, browser] = ['native', 'browser'].map(of);
  assert.equal(native.length, 4);
  browser.forEach((row, k) => {
    assert.ok(row.distance < 1e-10 && row.unmet === 0 && row.seconds > 0 && row.bytes > 1e6);
    for (const key of ['iterations', 'blockFactors', 'distance', 'moved', 'shortestEdge'])
      assert.equal(row[key], native[k][key], key);
  });
  assert.match(text, /\| rough \| 144 \| plane, exact \| browser \|/);
});
