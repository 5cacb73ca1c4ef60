// The offset in the view, and the tint of its failed panels.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { AppContext } from '../../../www/app/context.ts';
import { offsetLayer } from '../../../www/features/build/offset-layer.ts';
import type { Tint } from '../../../www/store/state.ts';

test('an offset that arrives after another mesh was opened tints none of its faces', () => {
  const tints: (Tint | null)[] = [];
  const tinted = () => [...(tints.at(-1)?.faces ?? [])];
  const model = { vertices: 4 };
  const app = {
    store: { get: () => ({ model }) },
    actions: { tint: (_: string, tint: Tint | null) => tints.push(tint) },
    viewport: { on: () => {}, unmeasured: () => {} },
  };
  const layer = offsetLayer(app as unknown as AppContext);
  const [edges, vertices] = [new Uint32Array(0), new Uint32Array(0)];
  const offset = (count: number) => ({
    ...{ points: new Float64Array(3 * count), edges, vertices, panels: Uint32Array.of(7) },
  });
  layer.show(offset(6));
  assert.deepEqual(tints, [null]);
  layer.show(offset(4));
  assert.deepEqual(tinted(), [7]);
});
