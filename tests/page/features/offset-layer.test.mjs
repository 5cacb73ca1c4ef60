// The offset in the view, and the tint of its failed panels.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { offsetLayer } from '../../../www/features/build/offset-layer.js';

test('an offset that arrives after another mesh was opened tints none of its faces', () => {
  const tints = [];
  const model = { vertices: 4 };
  const layer = offsetLayer({
    store: { get: () => ({ tint: null, model }), subscribe: () => {} },
    actions: { tint: (tint) => tints.push(tint) },
    viewport: { on: () => {}, unmeasured: () => {} },
  });
  const [edges, vertices] = [new Uint32Array(0), new Uint32Array(0)];
  const offset = (count) => ({
    ...{ points: new Float64Array(3 * count), edges, vertices, panels: Uint32Array.of(7) },
  });
  layer.show(offset(6));
  assert.deepEqual(tints, [null]);
  layer.show(offset(4));
  assert.deepEqual([...tints.at(-1).faces], [7]);
});
