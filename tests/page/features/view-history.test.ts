// The cameras to go back to.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';

globalThis.matchMedia = () => ({ matches: true }) as MediaQueryList;
const { ViewHistory } = await import('../../../www/features/view-tools/view-history.ts');

test('a view differs by its angles and, as far as it is away, by its lengths', async (context) => {
  // On a site, or in millimetres, no turn of the camera was another view.
  context.mock.timers.enable({ apis: ['setTimeout'] });
  globalThis.window = globalThis as unknown as typeof window;
  context.after(() => Reflect.deleteProperty(globalThis, 'window'));
  const store = createStore();
  const placed: number[][] = [];
  const view = { placeCamera: (camera: Float64Array) => placed.push([...camera]) };
  const viewport = { arrive() {}, with: (act: (of: typeof view) => void) => act(view) };
  const app = { store, viewport, solver: new Emitter(), actions: { setStatus() {} } };
  const history = new ViewHistory(app as unknown as AppContext);
  const seen = async (...camera: number[]) => {
    store.set({ camera });
    await Promise.resolve();
    context.mock.timers.tick(1000);
  };
  const site = [2_600_000, 1_200_000, 400];
  await seen(...site, 100, 0.5, 0.4, 0);
  await seen(...site, 100, 0.51, 0.4, 0);
  await seen(2_600_000, 1_200_001, 400, 100, 0.51, 0.4, 0);
  await seen(2_600_000, 1_200_001, 400, 100 + 1e-4, 0.51 + 1e-6, 0.4, 0);
  history.go(-1);
  history.go(-1);
  history.go(-1);
  assert.deepEqual(placed, [
    [...site, 100, 0.51, 0.4, 0],
    [...site, 100, 0.5, 0.4, 0],
  ]);
});
