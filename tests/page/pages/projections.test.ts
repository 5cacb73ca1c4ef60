// The mathematics of the page about projections: closest points, and descent of the steps.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  closestPoint,
  errors,
  project,
  reconcile,
  sum,
  type ConstraintSet,
  type Point,
} from '../../../www/pages/projections/sets.ts';

const sets: ConstraintSet[] = [
  { kind: 'line', at: [1, 2], turn: 0.4 },
  { kind: 'circle', at: [3, 1], radius: 1.5 },
  { kind: 'parabola', at: [2, -1], turn: -0.3, bend: 0.7 },
  { kind: 'parabola', at: [2, 1], turn: 2, bend: -2 },
];

/** Returns the point of the set with parameter t. */
function pointOf(set: ConstraintSet, t: number): Point {
  if (set.kind === 'circle') {
    return [set.at[0] + set.radius * Math.cos(t), set.at[1] + set.radius * Math.sin(t)];
  }
  const [c, s] = [Math.cos(set.turn), Math.sin(set.turn)];
  const v = set.kind === 'line' ? 0 : set.bend * t * t;
  return [set.at[0] + c * t - s * v, set.at[1] + s * t + c * v];
}

const distance = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1]);

const places: Point[] = [];
for (let x = -4; x <= 8; x += 0.75) for (let y = -5; y <= 6; y += 0.75) places.push([x, y]);

test('the closest point is on the set, and no other point of the set is closer', () => {
  for (const set of sets) {
    for (const x of places) {
      const y = closestPoint(set, x);
      assert.ok(distance(closestPoint(set, y), y) < 1e-9, `${set.kind} ${x}: stays`);
      let least = Infinity;
      for (let t = -12; t <= 12; t += 0.02) least = Math.min(least, distance(x, pointOf(set, t)));
      assert.ok(distance(x, y) <= least + 1e-12, `${set.kind} ${x}: ${distance(x, y)} > ${least}`);
      assert.ok(distance(x, y) >= least - 0.1, `${set.kind} ${x}: is on the set`);
    }
  }
});

test('special positions have a closest point too', () => {
  assert.deepEqual(closestPoint(sets[1], [3, 1]), [4.5, 1]);
  const parabola: ConstraintSet = { kind: 'parabola', at: [0, 0], turn: 0, bend: 1 };
  assert.ok(distance(closestPoint(parabola, [0, 0]), [0, 0]) < 1e-12);
  assert.ok(distance(closestPoint(parabola, [0, -3]), [0, 0]) < 1e-12);
  // A point on the axis above the centre of curvature has two closest points; that of the centre,
  // (0, 0.5), is the vertex.
  assert.ok(Math.abs(closestPoint(parabola, [0, 2])[1] - 1.5) < 1e-12);
  assert.ok(distance(closestPoint(parabola, [0, 0.5]), [0, 0]) < 1e-6);
});

test('the sum falls at every half step, while single terms may rise', () => {
  let rises = 0;
  for (const weights of [
    [1, 1, 1, 1],
    [1, 0, 3, 0.2],
    [0, 2, 0, 1],
  ]) {
    for (const start of places) {
      let x = start;
      let targets = project(sets, x);
      let before = errors(x, targets, weights);
      for (let k = 0; k < 8; k++) {
        x = reconcile(x, targets, weights);
        const moved = errors(x, targets, weights);
        targets = project(sets, x);
        const after = errors(x, targets, weights);
        assert.ok(sum(moved) <= sum(before) + 1e-9, 'step II');
        assert.ok(sum(after) <= sum(moved) + 1e-9, 'step I');
        rises += moved.filter((error, i) => error > before[i] + 1e-6).length;
        before = after;
      }
    }
  }
  assert.ok(rises > 0);
});

test('sets with a common point are all reached', () => {
  const feasible: ConstraintSet[] = [
    { kind: 'line', at: [0, 0], turn: 0.3 },
    { kind: 'circle', at: [0, 1], radius: 1 },
  ];
  let x: Point = [2.5, 1.5];
  for (let k = 0; k < 500; k++) x = reconcile(x, project(feasible, x), [1, 1]);
  assert.ok(sum(errors(x, project(feasible, x), [1, 1])) < 1e-12);
});

test('without weights the point does not move', () => {
  assert.deepEqual(reconcile([1, 2], project(sets, [1, 2]), [0, 0, 0, 0]), [1, 2]);
});
