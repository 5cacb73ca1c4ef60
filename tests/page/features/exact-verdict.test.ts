// The verdict on constraints that cannot be met, and their colours.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RunMessages } from '../../../www/features/warnings/run-messages.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import { createViewActions } from '../../../www/store/view-actions.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { Document as SceneDocument } from '../../../www/pkg/engine/shape_up.js';

globalThis.matchMedia = () => ({ matches: true }) as MediaQueryList;
const { ExactVerdict } = await import('../../../www/features/warnings/exact-verdict.ts');

/** The verdict on one constraint, which cannot be met unless another report is given. */
async function shown(
  report: object = { met: false, worst: [{ vertices: [2, 3] }] },
  lock: string[] = [],
  geometry: object | null = null,
  constraints: object[] = [],
) {
  const store = createStore();
  store.set({
    document: { constraints, lesson: { lock } } as unknown as SceneDocument,
    numbers: { exact: report } as unknown as State['numbers'],
  });
  const actions = {
    ask: {
      exactWords: async () => ({
        brief: 'not possible',
        numbers: '',
        suggestions: [{ label: 'Make plane soft', index: 0, within: null }],
      }),
    },
    tint: createViewActions(store).tint,
    select: (elements: object) => ({ edges: [], ...elements }),
    reportErrors: (begun: Promise<unknown>) => begun,
    trials: { improvement: () => new Promise(() => {}), exactOffer: async () => null },
  };
  const messages = new RunMessages({ store, actions } as unknown as AppContext);
  const viewport = { with() {} };
  const app = { store, actions, viewport, solver: { geometry } } as unknown as AppContext;
  await new ExactVerdict(app, messages, () => false).show();
  return { store, messages };
}

test('what cannot be met is coloured as long as that is said', async () => {
  // It stayed red when the problem was solved.
  const { store, messages } = await shown();
  assert.deepEqual(store.get().tints.unmet?.vertices, Uint32Array.of(2, 3));
  messages.withdraw();
  assert.equal(store.get().tints.unmet, null);
});

test('of faces and edges that cannot be met together, both are coloured', async () => {
  // The edges were left out.
  const worst = [{ vertices: [2, 0, 1] }, { vertices: [2, 3] }];
  const connectivity = {
    faceOffsets: Uint32Array.of(0, 3),
    faceIndices: Uint32Array.of(0, 1, 2),
    ...{ edges: Uint32Array.of(), edgeFaces: Uint32Array.of() },
  };
  const { store } = await shown({ met: false, worst }, [], { connectivity });
  const { faces, vertices } = store.get().tints.unmet ?? {};
  assert.deepEqual([faces, vertices], [Uint32Array.of(0), Uint32Array.of(2, 3)]);
});

test('what a lesson would refuse is not offered', async () => {
  // Pressing it withdrew the message, and was refused.
  const labels = async (lock: string[]) => {
    const { messages } = await shown(undefined, lock);
    return messages.now.value?.offers?.map(({ label }) => label);
  };
  assert.deepEqual(await labels(['weights']), ['Show them', 'Make plane soft']);
  assert.deepEqual(await labels(['constraints']), ['Show them']);
});

test('what is found for a message is said also after the card that it was on has gone', async () => {
  // "Looking for suggestions …" stayed for ever.
  const { store, messages } = await shown();
  const model = { faces: 4, panels: [{}] };
  const judged = {
    ...{ model, press: {}, kinds: [{ id: 'circle', panels: 'circular' }] },
    document: { constraints: [{ kind: 'circle', enabled: true }] },
  };
  store.set(judged as unknown as State);
  const message = messages.say({ words: 'too far', waits: 'Looking for suggestions …' });
  assert.equal(message.wasOnCard, true);
  store.set({ flatMap: {} as State['flatMap'] });
  messages.update(message, { waits: '' });
  assert.equal(messages.now.value?.waits, '');
});

test('what goes on can be stopped also where the card that it was on has no room', async () => {
  // It searched on under a docked panel or a flat map, without Stop.
  const { messages } = await shown({ met: true });
  assert.equal(messages.now.value?.isOpen, undefined);
  messages.now.value?.offers?.[0].act();
  const { isOpen, offers } = messages.now.value ?? {};
  assert.deepEqual([isOpen, offers?.[0].label], [true, 'Stop']);
});

test('a shape that is exact already is not made exact once more', async () => {
  // Each run accepted it again as a change, and what was undone could not be redone.
  const panels = { kind: 'plane', enabled: true, require: { within: 1 } };
  const { messages } = await shown({ met: true }, [], null, [panels]);
  const { result, words, offers } = messages.now.value ?? {};
  assert.deepEqual([result, words, offers?.[0].label], ['not possible', '', 'Improve']);
});

test('colours that are shown again after the message go with the next change', async () => {
  const { store, messages } = await shown();
  const [showThem] = messages.now.value?.offers ?? [];
  messages.withdraw();
  showThem.act();
  assert.ok(store.get().tints.unmet);
  messages.withdraw();
  assert.equal(store.get().tints.unmet, null);
});
