// When light from all around is shown: with every picture where that is fast, else once nothing moves.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { Budget, Refinement } from '../../../www/viewport/refinement.js';

const several = (budget, count, milliseconds) => {
  for (let i = 0; i < count; i++) budget.took(milliseconds);
};

test('it is live where pictures are fast, and not where one would take over 50 ms', () => {
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

test('it does not flicker', () => {
  const budget = new Budget();
  several(budget, 20, 16);
  // One slow picture in between is none.
  for (let i = 0; i < 10; i++) {
    several(budget, 2, 80);
    budget.took(16);
    assert.equal(budget.isLive, true);
  }
  // A machine that can do only the one without: each change of mind takes longer than the one before.
  let changes = 0;
  for (let i = 0, was = true; i < 2000; i++) {
    budget.took(budget.isLive ? 60 : 16);
    if (budget.isLive !== was) changes += 1;
    was = budget.isLive;
  }
  assert.ok(changes < 9, `${changes} changes`);
});

/** A view that knows what it was asked for, and a page that draws as the viewport does. */
function page() {
  const view = {
    amount: 0,
    fits: false,
    moved: true,
    setOcclusion(amount) {
      view.changed ||= amount !== view.amount;
      view.amount = amount;
    },
    occlusionFits: () => view.fits && !view.moved,
    needsDraw: () => view.moved || view.changed,
  };
  const shown = [];
  let asked = false;
  const refinement = new Refinement(() => (asked = true));
  const draw = () => {
    asked = false;
    refinement.prepare(view);
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

test('software shows it once nothing moves, and keeps it until something does', (t) => {
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
  // A mark that changes does not take it away.
  view.changed = true;
  draw();
  assert.deepEqual(shown.splice(0), [1]);
  view.moved = true;
  draw();
  assert.deepEqual(shown.splice(0), [0]);
});

test('what moves while it fades in is shown without it', (t) => {
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

test('who cannot wait has all of it with the next picture', () => {
  globalThis.requestAnimationFrame = mock.fn();
  const { view, shown, refinement, draw, drawAsked } = page();
  refinement.finish();
  drawAsked();
  assert.deepEqual(shown.splice(0), [1]);
  // Nor is there another one when it is there; what moves then is not held up.
  refinement.finish();
  drawAsked();
  view.moved = true;
  draw();
  assert.deepEqual(shown, [0]);
});
