// What `window.shapeUp` says of the state.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { scriptApi } from '../../../www/app/script-api.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore, type Store } from '../../../www/store/state.ts';
import type { Files } from '../../../www/documents/files.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Viewport } from '../../../www/viewport/viewport.ts';

/** The API on a store, without the rest of the page. */
const scriptOf = (store: Store) =>
  scriptApi(store, new Emitter() as unknown as SolverClient, {} as Viewport, {} as Files);

test('a view that still starts is starting, which differs from none', () => {
  const store = createStore();
  const script = scriptOf(store);
  const told = [script.state().renderer];
  for (const renderer of ['webgl2', 'none'] as const) {
    store.set({ renderer });
    told.push(script.state().renderer);
  }
  assert.deepEqual(told, ['starting', 'webgl2', 'none']);
});

test('the camera is read as a copy, and set for the view', () => {
  const store = createStore();
  const script = scriptOf(store);
  assert.equal(script.camera(), null);
  const camera = [1, 2, 3];
  script.look(camera);
  camera[0] = 9;
  assert.deepEqual(store.get().camera, [1, 2, 3]);
  const copy = script.camera();
  assert.deepEqual(copy, [1, 2, 3]);
  copy?.fill(0);
  assert.deepEqual(store.get().camera, [1, 2, 3]);
});
