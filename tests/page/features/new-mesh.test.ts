// What becomes of the trials of a new mesh.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import '../documents/storage.ts';
import { Openings } from '../../../www/documents/openings.ts';
import { Trial } from '../../../www/features/new-mesh/trial.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { Origin } from '../../../www/documents/files.ts';

/** Files that open whatever they are given, once files are read and trials are made. */
class Files extends Emitter<{ opened: void }> {
  origin: Origin = {};
  kept = 0;
  wait: (origin: Origin) => Promise<void> = () => Promise.resolve();
  #openings = new Openings();

  open(_: unknown, origin: Origin) {
    return this.#openings.begin(async (opening) => {
      if (!origin.trial) await this.wait(origin);
      if (!(await opening.isWanted())) return null;
      if (origin.trial) await this.wait(origin);
      opening.opened();
      this.origin = origin;
      this.emit('opened', undefined);
      return { vertices: 4, faces: 1 };
    });
  }
  keepTrial() {
    this.kept += 1;
  }
}

/** Trials of a square, until they are cancelled. */
async function cancelled(before: ConstructorParameters<typeof Trial>[1]) {
  const files = new Files();
  if (before) files.origin = before.origin;
  const trial = new Trial({ files } as unknown as AppContext, before);
  const end = trial.begin(() => {});
  trial.ask('Square', { make: () => ({ text: 'f 1 2 3 4', supports: [] }) });
  await new Promise((done) => files.once('opened', () => done(undefined)));
  end();
  await new Promise((done) => setTimeout(done));
  return files;
}

test('a mesh that was tried where nothing was open stays and is saved', async () => {
  // It used to stay a trial, which is never saved.
  const files = await cancelled(null);
  assert.equal(files.kept, 1);
});

test('a mesh that was tried in place of a model gives way to it', async () => {
  const files = await cancelled({ given: [], origin: { work: 'roof' } });
  assert.equal(files.kept, 0);
  assert.equal(files.origin.work, 'roof');
});

test('a file opened just after Cancel stays, although a trial was still being made', async () => {
  const files = new Files();
  const ends: Map<string | undefined, () => void> = new Map();
  files.wait = ({ trial, work }) =>
    new Promise((done) => {
      if (work === 'roof') done();
      ends.set(trial ? 'trial' : work, done);
    });
  const before = { given: [], origin: { work: 'roof' } };
  files.origin = before.origin;
  const trial = new Trial({ files } as unknown as AppContext, before);
  const end = trial.begin(() => {});
  trial.ask('Square', { make: () => ({ text: 'f 1 2 3 4', supports: [] }) });
  await new Promise((done) => setTimeout(done, 200));
  end();
  const own = files.open([], { work: 'own' });
  for (const one of ['trial', 'own']) {
    ends.get(one)?.();
    await new Promise((done) => setTimeout(done));
  }
  await own;
  await new Promise((done) => setTimeout(done));
  assert.equal(files.origin.work, 'own');
});

test('a mesh that could not be kept with its supports gives way to the model before', async () => {
  // Closing the dialog left the trial, which is never saved.
  const files = new Files();
  const before = { given: [], origin: { work: 'roof' } };
  files.origin = before.origin;
  const actions = { addHandles: async () => {}, ask: { scene: async () => '{}' }, setStatus() {} };
  const trial = new Trial({ files, actions } as unknown as AppContext, before);
  const end = trial.begin(() => {});
  trial.ask('Square', { make: () => ({ text: 'f 1 2 3 4', supports: [0] }) });
  await new Promise((done) => files.once('opened', () => done(undefined)));
  files.wait = async ({ work }) => {
    if (work !== 'roof') throw new Error('cancelled');
  };
  await trial.keep(() => assert.fail('the dialog stays'));
  end();
  await new Promise((done) => setTimeout(done));
  assert.equal(files.origin.work, 'roof');
});
