// Which row an edit is about, while edits that the page does not show yet change the list.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { editNow, type Lists } from '../../../www/solver/rows.ts';
import type { Edit } from '../../../www/pkg/engine/shape_up.js';

/** A list of constraints on the faces, by kind and weight. */
const list = (...rows: [string, number][]) =>
  ({
    constraints: rows.map(([kind, weight], index) => ({ index, kind, on: 'faces', weight })),
    variants: [],
  }) as unknown as Lists;
const off = (index: number): Edit => ({ setConstraint: { index, enabled: false } });

test('an edit reaches its row after another one has been removed or duplicated', () => {
  // The line was switched off in place of the plane.
  const shown = list(['circle', 1], ['plane', 1], ['line', 1]);
  assert.deepEqual(editNow(off(1), shown, list(['plane', 1], ['line', 1])), off(0));
  const doubled = list(['circle', 1], ['circle', 1], ['plane', 1], ['line', 1]);
  assert.deepEqual(editNow(off(1), shown, doubled), off(2));
  // Its own weight was changed meanwhile.
  assert.deepEqual(editNow(off(1), shown, list(['plane', 3], ['line', 1])), off(0));
});

test('rows of one kind are told apart by what they say, or else nothing is done', () => {
  const shown = list(['plane', 1], ['plane', 2]);
  assert.deepEqual(editNow(off(1), shown, list(['plane', 2])), off(0));
  assert.throws(() => editNow(off(1), shown, list(['plane', 5])), /changed meanwhile/);
  assert.throws(() => editNow(off(0), shown, list()), /changed meanwhile/);
  const remove: Edit = { removeConstraint: { index: 0 } };
  assert.equal(editNow(remove, shown, list()), null);
  assert.equal(editNow(remove, shown, list(['plane', 2])), null);
  // Its weight was changed and it was duplicated meanwhile: it stayed, without a word.
  const changed = list(['plane', 2], ['plane', 2]);
  assert.throws(() => editNow(remove, list(['plane', 1]), changed), /changed meanwhile/);
});

test('a kept shape is meant by its name, and other edits stay as they are', () => {
  const shown = { constraints: [], variants: ['Start', 'A', 'B'] };
  const now = { constraints: [], variants: ['Start', 'B'] };
  const goTo = (index: number): Edit => ({ goToVariant: { index } });
  assert.deepEqual(editNow(goTo(2), shown, now), goTo(1));
  assert.equal(editNow({ removeVariant: { index: 1 } }, shown, now), null);
  assert.equal(editNow('reset', shown, now), 'reset');
});
