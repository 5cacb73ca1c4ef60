// The drawing of a plan, with the engine's arcs.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DrawnPlan } from '../../../www/features/new-mesh/plan.ts';
import init from '../../../www/pkg/engine/shape_up.js';

test('a point that is added to an arc leaves its circle as it is', async () => {
  // Both halves became straight.
  await init({
    module_or_path: new URL('../../../www/pkg/engine/shape_up_bg.wasm', import.meta.url),
  });
  const plan = new DrawnPlan('m');
  const { radius, clockwise } = plan.now().side;
  assert.ok(radius);
  plan.insertPoint();
  const [before, after] = plan.sides.value.loops[0];
  for (const side of [before, after]) {
    assert.ok(Math.abs((side.radius ?? 0) - radius) < 1e-3 * radius);
    assert.equal(side.clockwise, clockwise);
  }
});
