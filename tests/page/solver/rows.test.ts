// Which row an edit is about, while edits that the page does not show yet change the list.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { editNow, type Lists } from '../../../www/solver/rows.ts';
import type { Edit } from '../../../www/pkg/engine/shape_up.js';

/** Constraints with these numbers, and kept shapes with these names. */
const lists = (numbers: number[], variants: string[] = []) =>
  ({
    constraints: numbers.map((number, index) => ({ index, number, kind: 'plane', on: 'faces' })),
    variants,
  }) as unknown as Lists;
const off = (index: number): Edit => ({ setConstraint: { index, enabled: false } });

test('an edit reaches its row after another one has been removed or duplicated, however alike', () => {
  // Another row of the same words was switched off in place of the one that had been removed.
  assert.deepEqual(editNow(off(1), 4, lists([4, 7])), off(0));
  assert.deepEqual(editNow(off(1), 4, lists([3, 9, 4, 7])), off(2));
  assert.throws(() => editNow(off(1), 4, lists([3, 7])), /changed meanwhile/);
  assert.equal(editNow({ removeConstraint: { index: 1 } }, 4, lists([3, 7])), null);
});

test('a kept shape is meant by its name', () => {
  const now = lists([], ['Start', 'B']);
  const goTo = (index: number): Edit => ({ goToVariant: { index } });
  assert.deepEqual(editNow(goTo(2), 'B', now), goTo(1));
  assert.equal(editNow({ removeVariant: { index: 1 } }, 'A', now), null);
});
