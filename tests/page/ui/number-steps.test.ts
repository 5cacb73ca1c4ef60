// What the arrow keys make of numbers.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { firstIn, nextNumber, type Steps } from '../../../www/ui/components/number-steps.ts';

/** The numbers from one on, going so many steps up or down. */
function steps(from: number, count: number, how: Steps = {}) {
  const by = count > 0 ? 1 : -1;
  const found = [];
  for (let at = from; found.length < Math.abs(count); found.push(at)) at = nextNumber(at, by, how);
  return found;
}

test('a number changes in its second digit, whatever its size', () => {
  // 0.005 m used to become 1.005 m.
  assert.deepEqual(steps(0.005, 2, { unit: 'm' }), [0.0051, 0.0052]);
  assert.deepEqual(steps(50, -2, { unit: 'mm' }), [49, 48]);
  assert.deepEqual(steps(2.5, 1), [2.6]);
  assert.deepEqual(steps(1234.5, 1), [1334.5]);
  assert.deepEqual(steps(-0.3, 1), [-0.29]);
  assert.deepEqual(steps(9.9, 2), [10, 11]);
});

test('a step up and a step down take each other back', () => {
  for (const from of [0.1, 0.099, 1, 10, -1, 7.3]) {
    assert.equal(nextNumber(nextNumber(from, 1, {}), -1, {}), from);
    assert.equal(nextNumber(nextNumber(from, -1, {}), 1, {}), from);
  }
});

test('from 0, lengths begin with about a centimetre', () => {
  const first = (unit: string) => steps(0, 1, { unit })[0];
  assert.deepEqual(['m', 'cm', 'mm', 'ft'].map(first), [0.01, 1, 10, 0.1]);
  assert.deepEqual(steps(0, -1, { unit: 'cm' }), [-1]);
});

test('whole numbers and degrees change by one', () => {
  assert.deepEqual(steps(144, 2, { step: 1 }), [145, 146]);
  assert.deepEqual(steps(0, -1, { step: 1 }), [-1]);
  assert.deepEqual(steps(22.5, 1, { step: 1 }), [23.5]);
});

test('a whole number without a unit stays whole, whether or not its field says so', () => {
  // 5 steps became 5.1, which is refused.
  assert.deepEqual(steps(5, 1), [6]);
  assert.deepEqual(steps(250, -1), [249]);
  assert.deepEqual(steps(1, -3), [0, -1, -2]);
  assert.deepEqual(steps(2, -2, { isPositive: true }), [1, 0.99]);
});

test('steps down come to 0 and cross it, where it is accepted', () => {
  // Each was a tenth of the one before, for ever.
  assert.deepEqual(steps(0.0001, -3, { unit: 'm' }), [0.000099, 0, -0.01]);
  assert.deepEqual(steps(-0.00005, 2, { unit: 'm' }), [0, 0.01]);
  assert.deepEqual(steps(0.05, -1, { unit: 'mm', isPositive: true }), [0.049]);
  assert.deepEqual(steps(0.2, -1, { unit: 'mm' }), [0.19]);
});

test('coordinates change alike, wherever they are', () => {
  // At 250 m one press moved 10 m.
  const coordinate = (from: number, unit: string, count: number) =>
    steps(from, count, { unit, step: firstIn(unit) });
  assert.deepEqual(coordinate(250, 'm', 1), [250.01]);
  assert.deepEqual(coordinate(0.01, 'm', -2), [0, -0.01]);
  assert.deepEqual(coordinate(15, 'mm', -2), [5, -5]);
});
