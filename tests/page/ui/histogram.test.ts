// The legend's histogram and its axis.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BINS, countsOf, greatestOf, spreadOf } from '../../../www/ui/plot/histogram.ts';
import {
  axisOf,
  positionOf,
  roundUp,
  tickExponents,
  valueAt,
} from '../../../www/ui/plot/value-axis.ts';

test('position and value on an axis are inverse to each other, on linear and logarithmic axes', () => {
  for (const axis of [axisOf(0, 8, false), axisOf(0.001, 8, true)])
    for (const value of [0.001, 0.5, 8]) {
      const there = valueAt(axis, positionOf(axis, value));
      assert.ok(Math.abs(there - value) < 1e-12, `${value} is at ${there}`);
    }
  assert.equal(positionOf(axisOf(0, 8, false), 9), 1);
  assert.equal(positionOf(axisOf(3, 3, false), 3), 0);
});

test('the ticks of a logarithmic axis are whole powers of ten, evenly spaced, at most seven', () => {
  assert.deepEqual(tickExponents(-2, 1), [-2, -1, 0, 1]);
  assert.deepEqual(tickExponents(-14, 0), [-14, -11, -8, -5, -2]);
  assert.deepEqual(tickExponents(1, 0), []);
});

test('ends are rounded up', () => {
  assert.deepEqual([0.9, 1.2, 7.3, 10, 1e-300].map(roundUp), [1, 1.5, 8, 10, 1e-300]);
  assert.deepEqual([0, NaN, Infinity].map(roundUp), [0, 0, 0]);
});

test('every face with a value is in one bar, those with the largest values in the last', () => {
  const values = Float32Array.of(0, 0.5, 1, NaN, 2);
  const counts = countsOf(values, axisOf(0, 1, false));
  assert.equal(counts.length, BINS);
  assert.equal(
    counts.reduce((sum, count) => sum + count),
    3,
  );
  assert.equal(counts.at(-1), 1);
  const { faces, within, greatest, original } = spreadOf(
    'planarity',
    values,
    axisOf(0, 2, false),
    0.5,
    values,
  );
  assert.deepEqual([faces, within, greatest, original?.greatest], [4, 2, 2, 2]);
});

test('values of both signs have an axis around zero, and the largest is that of either sign', () => {
  const values = Float32Array.of(-3, -1, 0, 0.5, 2, NaN);
  const axis = axisOf(-4, 4, false);
  const { greatest, faces, counts } = spreadOf('gauss', values, axis, null);
  assert.equal(greatest, 3);
  assert.equal(greatestOf(values), 3);
  assert.equal(faces, 5);
  assert.equal(
    counts.reduce((sum, count) => sum + count),
    5,
  );
  const middle = counts.length / 2;
  assert.equal(
    counts.slice(0, middle).reduce((sum, count) => sum + count),
    2,
  );
});
