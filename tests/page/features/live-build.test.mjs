// When the parts are built again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LiveBuild } from '../../../www/features/build/live-build.js';

test('faces that change during a build are built, although no vertex has moved', async () => {
  /** Corners of the meshes that were built. @type {number[]} */
  const built = [];
  /** Called when a build has begun. */
  let begun = () => {};
  globalThis.Worker = /** @type {any} */ (
    class {
      postMessage({ id, request }) {
        if (request.type === 'build') built.push(request.indices.length);
        begun();
        const value = request.type === 'offers' ? { presets: [], defaults: {} } : {};
        setTimeout(() => this.onmessage({ data: { id, value } }));
      }
    }
  );
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  const mesh = (offsets, indices) => ({
    positions,
    connectivity: {
      faceOffsets: Uint32Array.from(offsets),
      faceIndices: Uint32Array.from(indices),
    },
  });
  const state = {
    ...{ model: { faces: 1, vertices: 4 }, numbers: { iteration: 0 }, dragged: [], running: false },
    document: { units: 'm', build: {} },
  };
  const solver = { geometry: mesh([0, 3, 6], [0, 1, 2, 0, 2, 3]) };
  const app = /** @type {any} */ ({ store: { get: () => state }, solver });
  const live = new LiveBuild(app, {
    show() {},
    showOffset() {},
    refuse: (why) => assert.fail(why),
  });
  await live.offers();
  begun = () => {
    begun = () => {};
    // The triangles are joined to a quad.
    solver.geometry = mesh([0, 4], [0, 1, 2, 3]);
    live.update();
  };
  await live.update();
  assert.deepEqual(built, [6, 4]);
  await live.update();
  assert.deepEqual(built, [6, 4]);
});
