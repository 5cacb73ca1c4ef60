// The numbers at the end of `npm test` are those of the test programs.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { countTests } from '../../.scripts/count.mjs';

test('cargo: all test programs are added up', () => {
  const output = `
test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.02s
test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1.5s`;
  assert.deepEqual(countTests('cargo', output), { passed: 15, failed: 2 });
});

test('playwright: what did not run has not passed', () => {
  const output = `
  ✘  1 [desktop] › page.spec.mjs:5:1 › first paint (3.1s)

  1 failed
    [desktop] › page.spec.mjs:5:1 › first paint
  2 did not run
  7 passed (12.3s)`;
  assert.deepEqual(countTests('playwright', output), { passed: 7, failed: 3 });
});

test('node: the summary of its TAP form', () => {
  assert.deepEqual(countTests('node', '# tests 3\n# pass 2\n# fail 1\n'), { passed: 2, failed: 1 });
});
