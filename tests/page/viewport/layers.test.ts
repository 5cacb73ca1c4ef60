// What the view is told of the state.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createStore, type Tint } from '../../../www/store/state.ts';
import { createViewActions } from '../../../www/store/view-actions.ts';

globalThis.matchMedia = () => ({ matches: false }) as MediaQueryList;
const { LAYERS } = await import('../../../www/viewport/layers.ts');

test('of what is marked, the view shows the first cause that lasts', () => {
  // Pointing at a row took the red marks of constraints that cannot be met away, and so did Build.
  const store = createStore();
  const actions = createViewActions(store);
  const [[, show]] = LAYERS.filter(([keys]) => keys.includes('tints'));
  const marked = () => {
    let faces: number[] = [];
    const setTint = (_: Uint32Array, those: Uint32Array) => (faces = [...those]);
    show({ setTint } as never, store.get(), null);
    return faces;
  };
  const tintOf = (face: number): Tint => ({
    ...{ vertices: new Uint32Array(0), faces: Uint32Array.of(face), colour: [0, 0, 0] },
  });
  actions.tint('free', tintOf(0));
  actions.tint('unmet', tintOf(1));
  assert.deepEqual(marked(), [1]);
  actions.tint('pointed', tintOf(2));
  assert.deepEqual(marked(), [2]);
  actions.tint('pointed', null);
  actions.tint('unbuildable', tintOf(3));
  assert.deepEqual(marked(), [1]);
  actions.tint('unbuildable', null);
  assert.deepEqual(marked(), [1]);
  actions.tint('unmet', null);
  assert.deepEqual(marked(), [0]);
});

test('an audience sees no handles', () => {
  const store = createStore();
  const [[, show]] = LAYERS.filter(([keys]) => keys.includes('presenting'));
  const shown = () => {
    let handles: number[] = [];
    const setHandles = (those: Uint32Array) => (handles = [...those]);
    show({ setHandles } as never, store.get(), null);
    return handles;
  };
  const handles = [{ vertex: 4, target: [0, 0, 1], fixed: false, weight: 1 }];
  store.set({ document: { handles } as never });
  assert.deepEqual(shown(), [4]);
  store.set({ presenting: true });
  assert.deepEqual(shown(), []);
});

test('seams are drawn while Build makes a paper model', () => {
  const store = createStore();
  const [[, show]] = LAYERS.filter(([keys]) => keys.includes('docked'));
  const drawn = (docked: 'parts' | null, product: string) => {
    let ends: number[] = [];
    const setSeams = (those: Uint32Array) => (ends = [...those]);
    const build = {
      product,
      seams: [
        [3, 4],
        [9, 4],
      ],
    };
    show({ setSeams } as never, { ...store.get(), docked, document: { build } } as never, null);
    return ends;
  };
  assert.deepEqual(drawn('parts', 'paper'), [3, 4, 9, 4]);
  assert.deepEqual(drawn('parts', 'fins'), []);
  assert.deepEqual(drawn(null, 'paper'), []);
});
