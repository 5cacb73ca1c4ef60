// The loops of a plan: outward and inward arcs, loops drawn by hand, grid steps.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  bulgeThrough,
  extentOf,
  loopThrough,
  pathOf,
  roundStep,
  sideOf,
  type Place,
} from '../../../www/features/new-mesh/plan-geometry.ts';

const SQUARE: Place[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

test('an arc rises outward in either direction of the loop', () => {
  for (const places of [SQUARE, SQUARE.toReversed()]) {
    const points = places.map((at) => ({ at, bulge: 0.5 }));
    for (const [k] of points.entries()) {
      const { middle, rise } = sideOf(points, k);
      assert.equal(rise, 1);
      assert.ok(middle.some((x) => x === -1 || x === 5));
      assert.equal(bulgeThrough(points, k, middle), 0.5);
      assert.equal(bulgeThrough(points, k, [2, 2]), -1);
    }
    assert.deepEqual(extentOf([points]), { low: [-1, -1], high: [5, 5] });
  }
});

test('the path of a half circle has its radius and lies on the outer side of its chord', () => {
  const toPixels = ([x, y]: Place): Place => [10 * x, -10 * y];
  const points = SQUARE.map((at, k) => ({ at, bulge: k === 0 ? 1 : 0 }));
  // Below the square, from left to right: counterclockwise in a drawing whose y axis points down,
  // so sweep 0.
  assert.match(pathOf(points, toPixels, 10), /^M0 -?0A20 20 0 0 0 40 -?0L40 -40L0 -40L0 -?0Z$/);
  const inward = SQUARE.map((at, k) => ({ at, bulge: k === 0 ? -1 : 0 }));
  assert.match(pathOf(inward, toPixels, 10), /A20 20 0 0 1 40/);
});

test('a drawn loop is made counterclockwise, and its sharp convex turns become corners', () => {
  const letterL: Place[] = [
    [0, 0],
    [0, 4],
    [2, 4],
    [2, 2],
    [4, 2],
    [4, 0],
  ];
  const points = loopThrough(letterL, true);
  assert.deepEqual(
    points.map(({ at }) => at),
    letterL.toReversed(),
  );
  const inner = points.filter(({ corner }) => !corner);
  assert.deepEqual(
    inner.map(({ at }) => at),
    [[2, 2]],
  );
  assert.ok(loopThrough(letterL, false).every(({ corner }) => !corner));
});

test('grid steps are 1, 2 or 5 times a power of ten', () => {
  assert.equal(roundStep(24, 24), 1);
  assert.equal(roundStep(25, 24), 2);
  assert.equal(roundStep(100, 24), 5);
  assert.equal(roundStep(30000, 24), 2000);
});
