// What the view is told of the state.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createStore, type Tint } from '../../../www/store/state.ts';
import { createViewActions } from '../../../www/store/view-actions.ts';

globalThis.matchMedia = () => ({ matches: false }) as MediaQueryList;
const { LAYERS } = await import('../../../www/viewport/layers.ts');

test('what is pointed at is marked for that time, and then what was marked before', () => {
  // Pointing at a row took the red marks of constraints that cannot be met away.
  const store = createStore();
  const actions = createViewActions(store);
  const [[, show]] = LAYERS.filter(([keys]) => keys.includes('tint'));
  const marked = () => {
    let faces: number[] = [];
    const setTint = (_: Uint32Array, those: Uint32Array) => (faces = [...those]);
    show({ setTint } as never, store.get(), null);
    return faces;
  };
  const tintOf = (face: number): Tint => ({
    ...{ vertices: new Uint32Array(0), faces: Uint32Array.of(face), colour: [0, 0, 0] },
  });
  actions.look({ tint: tintOf(1) });
  assert.deepEqual(marked(), [1]);
  actions.look({ pointed: tintOf(2) });
  assert.deepEqual(marked(), [2]);
  actions.look({ pointed: null });
  assert.deepEqual(marked(), [1]);
  actions.look({ tint: null });
  assert.deepEqual(marked(), []);
});
