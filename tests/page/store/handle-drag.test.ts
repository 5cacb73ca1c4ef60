// A drag that the solver refuses leaves everything shown as it was.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { HandleDrag } from '../../../www/store/handles.ts';
import { handlesNow } from '../../../www/store/handles.ts';
import { createStore } from '../../../www/store/state.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Drag, SceneDocument } from '../../../www/solver/types.ts';

test('a refused drag ends at once, and neither its moves nor its end change a target', () => {
  const store = createStore();
  const handles = [{ vertex: 3, target: [1, 2, 3], fixed: false }];
  const document = { handles } as unknown as SceneDocument;
  store.set({ document });
  const sent: string[] = [];
  const solver = Object.assign(new Emitter<{ trouble: object }>(), {
    tell: { drag: ({ phase }: Drag) => sent.push(phase) },
  });
  const constrain = (_: string, dx: number, dy: number) => Float64Array.of(dx, dy, 0);
  const drag = new HandleDrag(store, solver as unknown as SolverClient, constrain, 3);
  drag.move(5, 0);
  assert.deepEqual(handlesNow(store.get())[0].target, [6, 2, 3]);
  solver.emit('trouble', { message: 'locked by the lesson' });
  assert.deepEqual(handlesNow(store.get()), handles);
  drag.move(9, 0);
  drag.end();
  assert.deepEqual(handlesNow(store.get()), handles);
  assert.deepEqual([store.get().dragged, store.get().moved], [[], null]);
  assert.deepEqual(sent, ['start', 'move', 'cancel']);
});
