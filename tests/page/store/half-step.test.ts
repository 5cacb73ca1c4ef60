// The two halves of an iteration, in words.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { halfStepWords } from '../../../www/store/half-step.ts';

test('a global step that is held says whether what is required is satisfied', () => {
  // It was said to be satisfied also after a run that had failed.
  const satisfied = /^Nothing moved: what is required is satisfied already, /;
  assert.match(halfStepWords({ half: 'held', met: true }), satisfied);
  assert.equal(
    halfStepWords({ half: 'held', met: false }),
    'Nothing moved: Run found no closer shape, and the global step would leave this one',
  );
});
