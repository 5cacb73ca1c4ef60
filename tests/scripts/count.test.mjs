// The totals of `npm test` match those of the test programs, and no skipped or flaky test is
// overlooked.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { countTests, inexcusable, isToRunAgain } from '../../.scripts/count.mjs';

const none = { skipped: [], flaky: [] };

test('cargo: the results of all test programs are added up', () => {
  const output = `
test factor::agrees ... ok
test result: ok. 12 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.02s
test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1.5s`;
  assert.deepEqual(countTests('cargo', output), { passed: 15, failed: 2, ...none });
});

test('cargo: ignored tests are named', () => {
  const output = `
test factor::agrees ... ok
test factor::large ... ignored
test factor::slow ... ignored, takes an hour
test result: ok. 1 passed; 0 failed; 2 ignored; 0 measured; 0 filtered out; finished in 0.02s`;
  const skipped = ['factor::large', 'factor::slow'];
  assert.deepEqual(countTests('cargo', output), { passed: 1, failed: 0, skipped, flaky: [] });
});

test('cargo: a test that passed without anything to look at is skipped', () => {
  const output = `
test topology::of_files ... ok

successes:

---- solve::speed stdout ----
3 ms

---- topology::of_files stdout ----
2 meshes
skipped: there is no ../shared
skipped: there is no ../shared

successes:
    topology::of_files
test result: ok. 12 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.02s`;
  const skipped = ['topology::of_files: there is no ../shared'];
  assert.deepEqual(countTests('cargo', output), { passed: 11, failed: 0, skipped, flaky: [] });
  assert.deepEqual(inexcusable(skipped), []);
});

test('playwright: tests that did not run have not passed', () => {
  const output = `
  ✘  1 [desktop] › page.spec.ts:5:1 › first paint (3.1s)

  1 failed
    [desktop] › page.spec.ts:5:1 › first paint
  2 did not run
  7 passed (12.3s)`;
  assert.deepEqual(countTests('playwright', output), { passed: 7, failed: 3, ...none });
});

test('playwright: skipped and flaky tests are named', () => {
  const output = `
  -  1 [phone] › app/axe.spec.ts:48:3 › axe: plots
  ✘  2 [desktop] › page.spec.ts:5:1 › first paint (3.1s)
  ✓  3 [desktop] › page.spec.ts:5:1 › first paint (retry #1) (1.1s)

  2 flaky
    [desktop] › page.spec.ts:5:1 › first paint
    [phone] › touch.spec.ts:9:1 › pinch
  1 skipped
  7 passed (12.3s)`;
  assert.deepEqual(countTests('playwright', output), {
    ...{ passed: 9, failed: 0 },
    skipped: ['[phone] › app/axe.spec.ts:48:3 › axe: plots'],
    flaky: ['[desktop] › page.spec.ts:5:1 › first paint', '[phone] › touch.spec.ts:9:1 › pinch'],
  });
});

test('node: the TAP summary is read', () => {
  const output = `ok 1 - reads\nok 2 - writes # SKIP no disk\n# tests 3\n# pass 2\n# fail 1\n# skipped 1\n`;
  const skipped = ['writes'];
  assert.deepEqual(countTests('node', output), { passed: 2, failed: 1, skipped, flaky: [] });
});

test('only listed tests are excused', () => {
  const excused = [{ name: 'touch.spec', reason: 'the machine has no fingers' }];
  const tests = ['[phone] › touch.spec.ts:9:1 › pinch', '[desktop] › page.spec.ts:5:1 › paint'];
  assert.deepEqual(inexcusable(tests, excused), [tests[1]]);
  // A step with another skip, or with anything flaky, is not stored as passed.
  assert.ok(isToRunAgain({ skipped: tests, flaky: [] }, excused));
  assert.ok(isToRunAgain({ skipped: [], flaky: tests.slice(0, 1) }, excused));
  assert.ok(!isToRunAgain({ skipped: tests.slice(0, 1), flaky: [] }, excused));
});
