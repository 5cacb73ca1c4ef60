// Which copy of the model a trial in the second worker goes on with.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import init from '../../../www/pkg/engine/shape_up.js';
import { copyOf, letGo } from '../../../www/worker/jobs/model-copy.ts';

/** A scene in which a bent quad shall be planar within a distance. */
const scene = (units: string) =>
  JSON.stringify({
    ...{ format: 'shape-up-scene', version: 1, units },
    mesh: {
      positions: [
        [0, 0, 0],
        [1, 0, 0],
        [1, 1, 0.2],
        [0, 1, 0],
      ],
      faces: [[0, 1, 2, 3]],
    },
    constraints: [{ kind: 'plane', on: 'faces', require: { within: 0.001 } }],
  });

test('a trial goes on although others ask about the model with another unit', async () => {
  await init({
    module_or_path: new URL('../../../www/pkg/engine/shape_up_bg.wasm', import.meta.url),
  });
  // The next question took its copy away: it was answered as if nothing had been found.
  const [before, after] = ['m', 'mm'].map((units) => ({ text: scene(units), generation: 5 }));
  copyOf('trials', before).tryExact();
  assert.equal(copyOf('questions', before), copyOf('trials'), 'one copy for both');
  copyOf('questions', after).forecast();
  while (copyOf('trials').advance());
  assert.equal(copyOf('trials').offer()?.met, true);
  letGo('trials');
  assert.throws(() => copyOf('trials'), /nothing has been begun/);
  assert.doesNotThrow(() => copyOf('questions', after).forecast());
});
