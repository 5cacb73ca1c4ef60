// How far wheels and pinches zoom.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { wheelFactor } from '../../../www/viewport/input/gestures.ts';

const factor = (deltaY: number, more: { ctrlKey?: boolean; deltaMode?: number } = {}) =>
  wheelFactor({ deltaY, ctrlKey: false, deltaMode: 0, ...more } as WheelEvent, 800);

test('the wheel zooms in upwards and out downwards by as much', () => {
  assert.ok(factor(-10) > 1);
  assert.ok(Math.abs(factor(-10) * factor(10) - 1) < 1e-12);
});

test('a pinch, which browsers report as a wheel with Ctrl, zooms more than a wheel', () => {
  assert.ok(factor(-10, { ctrlKey: true }) > factor(-10) ** 5);
});

test('lines and pages count as the pixels that they are high', () => {
  assert.equal(factor(-1, { deltaMode: 1 }), factor(-16));
  assert.equal(factor(-0.1, { deltaMode: 2 }), factor(-80));
});

test('one event zooms by a limited factor', () => {
  assert.equal(factor(-1e6), factor(-1e9));
  assert.ok(factor(-1e6) < 2);
});
