// When ambient occlusion is shown: in every picture if that is fast, else once nothing moves.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import type { View } from '../../../www/pkg/view-webgl2/shape_up.js';
import { Budget, Refinement } from '../../../www/viewport/refinement.ts';

const several = (budget: Budget, count: number, milliseconds: number) => {
  for (let i = 0; i < count; i++) budget.took(milliseconds);
};

test('ambient occlusion is live if pictures are fast, and not if one would take over 50 ms', () => {
  const budget = new Budget();
  assert.equal(budget.isLive, false);
  several(budget, 30, 40);
  assert.equal(budget.isLive, false, 'too slow to afford more');
  several(budget, 20, 16);
  assert.equal(budget.isLive, true);
  several(budget, 100, 45);
  assert.equal(budget.isLive, true, 'what it has it keeps up to 50 ms');
  several(budget, 5, 60);
  assert.equal(budget.isLive, false);
});

test('ambient occlusion does not flicker', () => {
  const budget = new Budget();
  several(budget, 20, 16);
  // Single slow pictures are ignored.
  for (let i = 0; i < 10; i++) {
    several(budget, 2, 80);
    budget.took(16);
    assert.equal(budget.isLive, true);
  }
  // A machine that is fast enough only without it: each change takes longer than the one before.
  let changes = 0;
  for (let i = 0, was = true; i < 2000; i++) {
    budget.took(budget.isLive ? 60 : 16);
    if (budget.isLive !== was) changes += 1;
    was = budget.isLive;
  }
  assert.ok(changes < 9, `${changes} changes`);
});

/** A view that records its settings, and a page that draws like the viewport. */
function page() {
  const view = {
    amount: 0,
    fits: false,
    moved: true,
    changed: false,
    setOcclusion(amount: number) {
      view.changed ||= amount !== view.amount;
      view.amount = amount;
    },
    occlusionFits: (): boolean => view.fits && !view.moved,
    needsDraw: (): boolean => view.moved || view.changed,
  };
  const shown: number[] = [];
  let asked = false;
  const refinement = new Refinement(() => (asked = true));
  const draw = () => {
    asked = false;
    refinement.prepare(view as unknown as View);
    if (!view.needsDraw()) return;
    view.fits = view.amount > 0;
    view.moved = view.changed = false;
    shown.push(view.amount);
    refinement.drawn();
  };
  const drawAsked = () => {
    while (asked) draw();
  };
  return { view, shown, refinement, draw, drawAsked };
}

test('in software ambient occlusion is shown once nothing moves, and stays until something does', (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  globalThis.requestAnimationFrame = mock.fn();
  const { view, shown, draw, drawAsked } = page();
  draw();
  t.mock.timers.tick(100);
  view.moved = true;
  draw();
  drawAsked();
  assert.deepEqual(shown.splice(0), [0, 0]);
  t.mock.timers.tick(1000);
  drawAsked();
  const steps = shown.splice(0);
  assert.ok(steps.length > 1, 'it fades in');
  assert.deepEqual(steps, [...steps].sort());
  assert.equal(steps.at(-1), 1);
  // A changed mark does not remove it.
  view.changed = true;
  draw();
  assert.deepEqual(shown.splice(0), [1]);
  view.moved = true;
  draw();
  assert.deepEqual(shown.splice(0), [0]);
});

test('motion during the fade-in is shown without ambient occlusion', (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  globalThis.requestAnimationFrame = mock.fn();
  const { view, shown, draw } = page();
  draw();
  t.mock.timers.tick(1000);
  draw();
  view.moved = true;
  draw();
  assert.equal(shown.at(-1), 0);
});

test('a caller that cannot wait gets full ambient occlusion in the next picture', () => {
  globalThis.requestAnimationFrame = mock.fn();
  const { view, shown, refinement, draw, drawAsked } = page();
  refinement.finish();
  drawAsked();
  assert.deepEqual(shown.splice(0), [1]);
  // There is no further picture once it is shown; later motion is not held up.
  refinement.finish();
  drawAsked();
  view.moved = true;
  draw();
  assert.deepEqual(shown, [0]);
});
