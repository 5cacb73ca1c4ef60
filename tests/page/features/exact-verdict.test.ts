// The verdict on constraints that cannot be met, and their colours.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RunMessages } from '../../../www/features/warnings/run-messages.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { SceneDocument } from '../../../www/solver/types.ts';

globalThis.matchMedia = () => ({ matches: true }) as MediaQueryList;
const { ExactVerdict } = await import('../../../www/features/warnings/exact-verdict.ts');

/** The verdict on one constraint that cannot be met. */
async function shown() {
  const store = createStore();
  store.set({
    document: { constraints: [] } as unknown as SceneDocument,
    numbers: {
      exact: { met: false, worst: [{ vertices: [2, 3] }] },
    } as unknown as State['numbers'],
  });
  const actions = {
    ask: { exactWords: async () => ({ brief: 'not possible', numbers: '', suggestions: [] }) },
    look: (change: Partial<State>) => store.set(change),
  };
  const messages = new RunMessages(store);
  const app = { store, actions, solver: { geometry: null } } as unknown as AppContext;
  await new ExactVerdict(app, messages, () => false).show();
  return { store, messages };
}

test('what cannot be met is coloured as long as that is said', async () => {
  // It stayed red when the problem was solved.
  const { store, messages } = await shown();
  assert.deepEqual(store.get().tint?.vertices, Uint32Array.of(2, 3));
  messages.withdraw();
  assert.equal(store.get().tint, null);
});

test('colours that are shown again after the message go with the next change', async () => {
  const { store, messages } = await shown();
  const [showThem] = messages.now.value?.offers ?? [];
  messages.withdraw();
  showThem.act();
  assert.ok(store.get().tint);
  messages.withdraw();
  assert.equal(store.get().tint, null);
});

test('the colours of a row that is pointed at are left', async () => {
  const { store, messages } = await shown();
  const row = { vertices: Uint32Array.of(1), faces: Uint32Array.of(), colour: [0, 0, 0] };
  store.set({ tint: row as State['tint'] });
  messages.withdraw();
  assert.equal(store.get().tint, row);
});
