// What becomes of the trials of a new mesh.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import '../documents/storage.ts';
import { Trial } from '../../../www/features/new-mesh/trial.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { Origin } from '../../../www/documents/files.ts';

/** Files that open at once whatever they are given. */
class Files extends Emitter<{ opened: void }> {
  origin: Origin = {};
  kept = 0;

  async open(_: unknown, origin: Origin) {
    this.origin = origin;
    this.emit('opened', undefined);
    return { vertices: 4, faces: 1 };
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
