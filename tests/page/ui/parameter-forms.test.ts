// How a value becomes one of another form.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { converted } from '../../../www/ui/kinds/parameter-forms.ts';
import type { Param } from '../../../www/pkg/engine/shape_up.js';

test('the number for a range is within it, with few digits', () => {
  // Two digits took it out of narrow ranges, and the run followed.
  const length = { default: [0, null], range: [0, null], unit: 'length' } as unknown as Param;
  const frame = { units: 'm', up: 'z', meanEdge: 1 } as const;
  const middle = (low: number, high: number) => converted(length, 'number', [low, high], frame);
  assert.equal(middle(10, 20), 15);
  assert.equal(middle(12.34, 12.36), 12.35);
  assert.equal(middle(1.52, 1.58), 1.55);
  assert.equal(middle(1 / 3, 1 / 3), 1 / 3);
});
