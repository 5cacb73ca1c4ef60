// To which saved work a scene belongs.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import './storage.mjs';
import { Autosave } from '../../../www/documents/autosave.js';
import { contentsOf } from '../../../www/documents/recent-documents.js';
import { Emitter } from '../../../www/solver/emitter.js';
import { createStore } from '../../../www/store/state.js';

/** The parts of the solver that autosave follows. */
class Solver extends Emitter {
  restoring = false;
  sceneText = 'the roof';
  saved = { iteration: 0, history: null, progress: null };

  model(restoring) {
    this.restoring = restoring;
    this.emit('model', {});
  }
  scene(text) {
    this.sceneText = text;
    this.emit('scene', {});
  }
}

test('autosave goes on after the opening of another file was cancelled', async (context) => {
  // It used to be off for the rest of the visit.
  context.after(() => ['document', 'location'].forEach((name) => delete globalThis[name]));
  globalThis.document = /** @type {any} */ ({ addEventListener() {} });
  globalThis.location = /** @type {any} */ ({ hash: '' });
  const solver = /** @type {any} */ (new Solver());
  const files = Object.assign(new Emitter(), { origin: {}, original: null, name: 'roof' });
  const store = createStore();
  store.set({ model: /** @type {any} */ ({ title: '', name: 'roof.obj' }) });
  const seen = { store, actions: { describeFile() {} }, analysis: { shown: () => '' } };
  const autosave = new Autosave(solver, /** @type {any} */ (files), /** @type {any} */ (seen));
  const { id } = autosave;
  await autosave.save();

  solver.model(false);
  solver.scene('a large mesh');
  await autosave.save();
  assert.equal(autosave.id, '');
  assert.equal((await contentsOf(id)).text, 'the roof');

  solver.model(true);
  solver.scene('the roof with a door');
  await autosave.save();
  assert.equal(autosave.id, id);
  assert.equal((await contentsOf(id)).text, 'the roof with a door');
});
