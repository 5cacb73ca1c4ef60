// A flat map belongs to the shape that the solver gave for it, whatever the page shows meanwhile.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { flatMaps } from '../../../www/features/flat-map/flat-maps.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { mapInWords } from '../../../www/store/stale-map.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';

test('a map that is made during a run is of the shape at which that ends', async () => {
  const store = createStore();
  store.set({ model: { vertices: 1 } as State['model'] });
  // The last frame of the run comes after the answer, because the page was busy with the one before.
  const geometry = { solved: 4, positions: Float64Array.of(0, 0, 0) };
  const solver = Object.assign(new Emitter<{ frame: void }>(), { geometry });
  const show = (solved: number, x: number) => {
    Object.assign(geometry, { solved, positions: Float64Array.of(x, 0, 0) });
    solver.emit('frame', undefined);
  };
  const found = { seconds: 0, parts: 1, closedParts: 0, flipped: 0 };
  let parametrize: (weights: string) => Promise<object> = async () => found;
  const app = {
    ...{ store, solver, viewport: {} },
    jobs: { copy: () => ({ parametrize: (weights: string) => parametrize(weights) }) },
    actions: {
      rest: async () => ({ text: '', generation: 5 }),
      setStatus: (status: string) => store.set({ status }),
      look: (look: Partial<State>) => store.set(look),
      reportErrors: (refused: Promise<unknown>) => refused.catch(() => {}),
    },
  } as unknown as AppContext;
  const maps = flatMaps(app);
  const made = maps.flatten();
  await new Promise((done) => setTimeout(done, 5));
  show(5, 1);
  await made;
  const { flatMap } = store.get();
  assert.ok(flatMap);
  // A file of the shape had the map of another one without a word.
  const words = () => mapInWords(app, { ...store.get(), numbers: {} as State['numbers'] });
  assert.equal(words(), 'with its flat map');
  show(6, 1);
  assert.equal(words(), 'with its flat map', 'an edit that moves nothing');
  show(7, 2);
  assert.equal(words(), 'with the flat map of an earlier shape');
  show(8, 1);
  assert.equal(words(), 'with its flat map', 'undone');

  // Weights of a map that was refused were those of the next one, although others were shown.
  parametrize = () => Promise.reject(new Error('refused'));
  maps.choose({ weights: 'lscm' });
  await new Promise((done) => setTimeout(done, 5));
  const asked: string[] = [];
  parametrize = async (weights) => (asked.push(weights), found);
  show(5, 1);
  await maps.flatten();
  assert.deepEqual(asked, [flatMap.weights]);
});
