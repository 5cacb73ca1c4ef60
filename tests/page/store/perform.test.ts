// A command runs only if it is enabled, wherever it is pressed; menus used to bypass that.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isEnabled, perform, runEarlyPresses } from '../../../www/store/perform.ts';
import { createStore } from '../../../www/store/state.ts';
import type { Command } from '../../../www/app/context.ts';
import type { Document as SceneDocument } from '../../../www/pkg/engine/shape_up.js';

const command = (done: string[], more: Partial<Command> = {}): Command => ({
  id: 'fit',
  group: 'View',
  label: 'Fit',
  keys: [],
  action: () => done.push('fit'),
  ...more,
});

test('a disabled command does not run', () => {
  const store = createStore();
  const done: string[] = [];
  const drawn = command(done, { enabled: ({ renderer }) => renderer !== 'none' });
  store.set({ renderer: 'none' });
  assert.equal(isEnabled(drawn, store.get()), false);
  perform(drawn, store);
  assert.deepEqual(done, []);
  store.set({ renderer: 'webgl2' });
  perform(drawn, store);
  assert.deepEqual(done, ['fit']);
  assert.equal(isEnabled(command(done), store.get()), true);
});

test('a key pressed right after an edit waits for it, if that may enable its command', async () => {
  const store = createStore();
  const done: string[] = [];
  const undo = command(done, { enabled: ({ document }) => Boolean(document?.undo) });
  perform(undo, store, async () => store.set({ document: { undo: 'Weight' } as SceneDocument }));
  assert.deepEqual(done, []);
  await new Promise((end) => setTimeout(end));
  assert.deepEqual(done, ['fit']);
  perform(undo, store, () => Promise.reject(new Error('not asked for an enabled command')));
  assert.deepEqual(done, ['fit', 'fit']);
});

test('a command that needs a model waits for it and runs once', async () => {
  const store = createStore();
  const done: string[] = [];
  const waiting = command(done, { needsModel: true });
  runEarlyPresses([waiting], store, ['fit', 'fit']);
  assert.deepEqual(done, []);
  assert.notEqual(store.get().status, '');
  store.set({ document: {} as SceneDocument });
  await Promise.resolve();
  assert.deepEqual(done, ['fit']);
});
