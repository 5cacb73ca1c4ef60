// The offset in the view, and the tint of its failed panels.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { AppContext } from '../../../www/app/context.ts';
import { offsetLayer } from '../../../www/features/build/offset-layer.ts';
import type { Tint } from '../../../www/store/state.ts';

/** A page whose solver has this geometry, the numbers of points drawn, and the faces tinted. */
function page() {
  const solver = { geometry: { connectivity: {} } };
  const drawn: number[] = [];
  const tinted: number[][] = [];
  const view = { setLayer: (points: Float64Array) => drawn.push(points.length / 3) };
  const on: { ready?: () => void } = {};
  const app = {
    solver,
    actions: { tint: (_: string, tint: Tint | null) => tinted.push([...(tint?.faces ?? [])]) },
    viewport: {
      on: (name: 'ready', listener: () => void) => (on[name] = listener),
      unmeasured: (draw: (given: typeof view) => void) => draw(view),
    },
  };
  const layer = offsetLayer(app as unknown as AppContext);
  return { solver, drawn, tinted, layer, ready: () => on.ready?.() };
}

const NONE = new Uint32Array(0);
const offset = (count: number) => ({
  ...{ points: new Float64Array(3 * count), edges: NONE, vertices: NONE },
  panels: Uint32Array.of(7),
});

test('failed panels are tinted although there is no offset', () => {
  const { drawn, tinted, layer } = page();
  layer.show(offset(0));
  assert.deepEqual([drawn, tinted], [[0], [[7]]]);
});

test('an offset is not drawn on another mesh, of as many vertices, that was opened since', () => {
  const { solver, drawn, layer, ready } = page();
  layer.show(offset(4));
  ready();
  solver.geometry = { connectivity: {} };
  ready();
  assert.deepEqual(drawn, [4, 4, 0]);
});
