// To which saved work a scene belongs.

import assert from 'node:assert/strict';
import { test, type TestContext } from 'node:test';
import { locks, records } from './storage.ts';
import { Autosave, take } from '../../../www/documents/autosave.ts';
import {
  LOCK_PREFIX,
  contentsOf,
  recentDocuments,
} from '../../../www/documents/recent-documents.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore } from '../../../www/store/state.ts';
import type { Files, Origin } from '../../../www/documents/files.ts';
import type { Loaded, Saved } from '../../../www/solver/types.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Actions } from '../../../www/store/actions.ts';

/** The parts of the solver that autosave follows. */
class Solver extends Emitter<{ model: object; scene: object; progress: { iteration: number } }> {
  restoring = false;
  sceneText = 'the roof';
  saved: Saved = { iteration: 0, history: null, progress: null };

  model(restoring: boolean) {
    this.restoring = restoring;
    this.emit('model', {});
  }
  scene(text: string) {
    this.sceneText = text;
    this.emit('scene', {});
  }
  progress(iteration: number) {
    this.saved = { ...this.saved, progress: new Uint8Array(1) };
    this.emit('progress', { iteration });
  }
}

/** Autosave of an open model. */
function started(context: TestContext) {
  context.after(() => {
    for (const name of ['document', 'location']) Reflect.deleteProperty(globalThis, name);
  });
  globalThis.document = { addEventListener() {} } as unknown as Document;
  globalThis.location = { hash: '' } as Location;
  const solver = new Solver();
  const origin: Origin = {};
  const files = Object.assign(new Emitter<{ opened: void }>(), {
    ...{ origin, original: null as string | null, name: 'roof' },
  });
  const store = createStore();
  /** What is said of the autosave. */
  const said: string[] = [];
  store.set({ model: { title: '', name: 'roof.obj' } as Loaded });
  const autosave = new Autosave(
    solver as unknown as SolverClient,
    files as unknown as Files,
    store,
    { look: ({ saved }: { saved: string }) => said.push(saved) } as unknown as Actions,
  );
  return { solver, files, autosave, said };
}

test('autosave goes on after the opening of another file was cancelled', async (context) => {
  // It used to be off for the rest of the visit.
  const { solver, autosave } = started(context);
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

test('a work says of which file it is, as long as it is not changed', async (context) => {
  const { solver, files, autosave } = started(context);
  const fileOf = async () => {
    await autosave.save();
    return (await recentDocuments()).find(({ id }) => id === autosave.id)?.file;
  };
  await autosave.save();
  files.origin = { file: 'of the roof' };
  files.original = 'the roof';
  files.emit('opened', undefined);
  assert.equal(await fileOf(), 'of the roof');
  solver.scene('the roof with a door');
  assert.equal(await fileOf(), null);
  solver.scene('the roof');
  assert.equal(await fileOf(), 'of the roof');
});

test('a link that is only solved is not changed', async (context) => {
  // Eight of them, followed to look at, pushed works of one's own out of the browser.
  const { solver, files, autosave } = started(context);
  const scene = (change: object) => JSON.stringify({ mesh: {}, constraints: [], ...change });
  await autosave.save();
  files.origin = { file: 'of the link', link: '#link=abc' };
  files.original = solver.sceneText = scene({});
  files.emit('opened', undefined);
  const fileOf = async (change: object) => {
    solver.scene(scene(change));
    await autosave.save();
    return (await recentDocuments()).find(({ id }) => id === autosave.id)?.file;
  };
  assert.equal(await fileOf({ current: [[0, 0, 1]] }), 'of the link');
  solver.progress(7);
  assert.equal(await fileOf({ current: [[0, 0, 2]] }), 'of the link');
  assert.equal(await fileOf({ current: [[0, 0, 1]], title: 'Mine' }), null);
  // A shape made with a handle that was removed again was deleted when its link was opened again.
  assert.equal(await fileOf({ current: [[0, 0, 3]] }), null);
});

test('what is changed just before another file is opened is saved', async (context) => {
  // A change that came while the one before was being written belonged to no work any longer.
  const { solver, files, autosave } = started(context);
  const { id } = autosave;
  await autosave.save();
  solver.scene('the roof with a door');
  solver.scene('the roof with a window');
  solver.model(false);
  solver.scene('another mesh');
  files.origin = {};
  files.emit('opened', undefined);
  await autosave.save();
  assert.notEqual(autosave.id, id);
  assert.equal((await contentsOf(id)).text, 'the roof with a window');
  assert.equal((await contentsOf(autosave.id)).text, 'another mesh');
});

test('a work that is opened again while another tab has it becomes another work', async (context) => {
  // As by Undo of a new mesh. Both tabs used to save to the same work.
  const { solver, files, autosave } = started(context);
  const { id } = autosave;
  await autosave.save();
  solver.model(false);
  files.origin = {};
  files.emit('opened', undefined);
  await autosave.save();
  const lock = LOCK_PREFIX + id;
  assert.equal(locks.has(lock), false);

  locks.add(lock);
  solver.model(false);
  solver.scene('the roof with a door');
  files.origin = { work: id };
  files.emit('opened', undefined);
  solver.scene('the roof with a window');
  await new Promise((done) => setTimeout(done));
  await autosave.save();
  assert.notEqual(autosave.id, id);
  assert.equal(files.origin.work, autosave.id);
  assert.equal((await contentsOf(id)).text, 'the roof');
  assert.equal((await contentsOf(autosave.id)).text, 'the roof with a window');
});

test('a work for which there is no room holds up no other', async (context) => {
  // The first save of the next model was dropped, and it was said that autosave is off.
  const { solver, files, autosave, said } = started(context);
  await autosave.save();
  const set = Map.prototype.set.bind(records);
  context.mock.method(records, 'set', (key: string, value: unknown) => {
    if (value === 'too large') throw new DOMException('Full.', 'QuotaExceededError');
    return set(key, value);
  });
  solver.scene('too large');
  solver.model(false);
  solver.scene('another mesh');
  files.origin = {};
  files.emit('opened', undefined);
  const isSaved = async () => (await contentsOf(autosave.id)).text === 'another mesh';
  for (let tries = 0; tries < 50 && !(await isSaved()); tries++);
  assert.ok(await isSaved());
  assert.ok(!said.some((words) => words.includes('off')), `${said}`);
});

test('what could not be saved while another file was being opened is saved after its cancelling', async (context) => {
  // It was taken for saved until the next edit.
  const { solver, autosave } = started(context);
  const { id } = autosave;
  await autosave.save();
  const set = Map.prototype.set.bind(records);
  const broken = context.mock.method(records, 'set', (key: string, value: unknown) => {
    if (value === 'with a door') throw new DOMException('Broken.', 'UnknownError');
    return set(key, value);
  });
  solver.scene('with a door');
  solver.model(false);
  await autosave.save();
  broken.mock.restore();
  solver.model(true);
  solver.scene('with a door');
  await autosave.save();
  assert.equal((await contentsOf(id)).text, 'with a door');
});

test('a work that has gone on is listed at its iteration, and restored from that of its scene', async (context) => {
  // "Iteration 0" was said of a run of 400.
  const { solver, autosave } = started(context);
  await autosave.save();
  solver.progress(400);
  await autosave.save();
  const [work] = (await recentDocuments()).filter(({ id }) => id === autosave.id);
  assert.equal(work.iteration, 400);
  locks.clear();
  assert.equal((await take(work))?.saved.iteration, 0);
});
