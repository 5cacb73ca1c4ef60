// Which row an edit is about, while edits that the page does not show yet change the list.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { editNow, rowOf, type Lists } from '../../../www/solver/rows.ts';
import type { Edit } from '../../../www/pkg/engine/shape_up.js';

/** Constraints with these numbers, and kept shapes with these names. */
const lists = (numbers: number[], variants: string[] = []) =>
  ({
    constraints: numbers.map((number, index) => ({ index, number, kind: 'plane', on: 'faces' })),
    variants,
  }) as unknown as Lists;
const off = (index: number): Edit => ({ setConstraint: { index, enabled: false } });
/** The edit of what is shown, with the lists as they are now. */
function made(edit: Edit, shown: Lists, now: Lists) {
  const row = rowOf(edit, shown);
  return row === undefined ? edit : editNow(edit, row, now);
}

test('an edit reaches its row after another one has been removed or duplicated, however alike', () => {
  // Another row of the same words was switched off in place of the one that had been removed.
  const shown = lists([3, 4, 7]);
  assert.deepEqual(made(off(1), shown, lists([4, 7])), off(0));
  assert.deepEqual(made(off(1), shown, lists([3, 9, 4, 7])), off(2));
  assert.throws(() => made(off(1), shown, lists([3, 7])), /changed meanwhile/);
  assert.equal(made({ removeConstraint: { index: 1 } }, shown, lists([3, 7])), null);
});

test('a kept shape is meant by its name, and other edits stay as they are', () => {
  const [shown, now] = [lists([], ['Start', 'A', 'B']), lists([], ['Start', 'B'])];
  const goTo = (index: number): Edit => ({ goToVariant: { index } });
  assert.deepEqual(made(goTo(2), shown, now), goTo(1));
  assert.equal(made({ removeVariant: { index: 1 } }, shown, now), null);
  assert.equal(made('reset', shown, now), 'reset');
  assert.deepEqual(made({ showStep: { index: 1 } }, shown, now), { showStep: { index: 1 } });
});
