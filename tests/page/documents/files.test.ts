// What is opened, what is said of what is not, and the model before another.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Actions } from '../../../www/store/actions.ts';
import type { Alerts } from '../../../www/ui/controls/alerts.tsx';

const page = {
  ...{ baseURI: 'http://localhost/', documentElement: { dataset: {} } },
  getElementById: () => null,
};
globalThis.document = page as unknown as Document;
globalThis.location = { hash: '', pathname: '/', search: '' } as Location;
const { Files } = await import('../../../www/documents/files.ts');

/** Files of a page whose solver refuses those called `broken`. */
function opening() {
  const store = createStore();
  store.set({ document: {} as State['document'] });
  const told: string[] = [];
  const solver = Object.assign(new Emitter<object>(), {
    ...{ sceneText: '{}', saved: {} },
    async open({ files: [{ name }] }: { files: { name: string }[] }) {
      if (name.startsWith('broken')) throw new Error(`${name} is damaged`);
      return {};
    },
  });
  const error = (message: string) => void told.push(message);
  const actions = {
    look: (about: Partial<State>) => store.set(about),
    setStatus() {},
    settled: async () => {},
    rest: async () => ({ text: '{}' }),
    reportErrors: (promise: Promise<unknown>) =>
      Promise.resolve(promise).catch(({ message }: Error) => error(message)),
    ask: { missingFiles: async (): Promise<string[]> => [] },
  };
  const files = new Files(
    store,
    solver as unknown as SolverClient,
    { error, clear() {} } as unknown as Alerts,
    actions as unknown as Actions,
  );
  const open = (name: string, origin = {}) =>
    files.open([{ name, bytes: new Uint8Array(1) }], origin);
  return { files, actions, open, told };
}

test('the refusal of a file is not told over a model that has come since', async () => {
  // It was, where the question for the files that it misses had to wait for that opening.
  const { actions, open, told } = opening();
  /** Opens a file that is refused; resolves with how the question about it is answered. */
  const refused = async () => {
    let opened: Promise<unknown> = Promise.resolve();
    const answer = await new Promise<() => void>((asked) => {
      actions.ask.missingFiles = () => new Promise((done) => asked(() => done([])));
      opened = open('broken.json').catch(() => 'refused');
    });
    return { answer, opened };
  };
  const before = await refused();
  await open('roof.obj');
  before.answer();
  assert.equal(await before.opened, null);
  assert.deepEqual(told, []);
  const again = await refused();
  again.answer();
  assert.equal(await again.opened, 'refused');
  assert.deepEqual(told, ['broken.json is damaged']);
});

test('why the model before another one does not come back is told', async () => {
  // Ctrl+Z did nothing when the open model could not be kept for Redo.
  const { files, actions, open, told } = opening();
  await open('roof.obj');
  const before = await files.asItIs();
  await open('grid.obj', { before, step: 'New mesh' });
  actions.rest = () => Promise.reject(new Error('the solver stopped'));
  await files.goBack();
  assert.deepEqual(told, ['the solver stopped']);
});
