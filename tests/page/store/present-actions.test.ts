// The steps of a presentation, shown one after another.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { presentActions } from '../../../www/store/present-actions.ts';
import type { Actions } from '../../../www/store/actions.ts';
import type { Store } from '../../../www/store/state.ts';

test('a step that is passed, or whose model is left, before its shape has arrived neither runs nor moves the camera', async () => {
  const steps = [
    { title: 'Flat', weights: { shape: 1, close: 1, smooth: 0 }, camera: [1], run: true },
    { title: 'The design', original: true, camera: [2] },
  ];
  const told: string[] = [];
  const actions = {
    edit: () => new Promise((done) => setTimeout(() => done(null))),
    look: ({ camera }: { camera?: number[] }) => camera && told.push(`camera ${camera}`),
    run: () => told.push('run'),
    runOrPause: () => told.push('pause'),
  };
  let model = {};
  const store = { get: () => ({ document: { steps }, running: false, model }) };
  const slides = presentActions(store as unknown as Store, actions as unknown as Actions);
  await Promise.all([slides.showStep(0), slides.showStep(1)]);
  assert.deepEqual(told, ['camera 2']);
  await slides.showStep(0);
  assert.deepEqual(told, ['camera 2', 'camera 1', 'run']);
  // The model that was being opened got the camera, and was run.
  const shown = slides.showStep(0);
  model = {};
  await shown;
  assert.deepEqual(told.splice(3), []);
});
