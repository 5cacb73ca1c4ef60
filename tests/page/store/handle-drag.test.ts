// One drag of handles at a time; each is over when it is ended here, by the next one, or by the solver.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { Drags, handlesNow } from '../../../www/store/handles.ts';
import { createStore } from '../../../www/store/state.ts';
import type { WorkerEvents } from '../../../www/solver/events.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Document as SceneDocument } from '../../../www/pkg/engine/shape_up.js';
import type { Drag } from '../../../www/solver/types.ts';

const HANDLE = { vertex: 3, target: [1, 2, 3], weight: 1, fixed: false } as const;
const constrain = (_: string, dx: number, dy: number) => Float64Array.of(dx, dy, 0);

/** Drags of one handle, and the messages that they send. */
function dragsOfOne() {
  const store = createStore();
  store.set({ document: { handles: [HANDLE] } as unknown as SceneDocument });
  const sent: [number, string, ...number[]][] = [];
  const solver = Object.assign(new Emitter<Pick<WorkerEvents, 'dragEnded' | 'model'>>(), {
    tell: {
      drag: ({ id, phase, targets }: Drag) => sent.push([id, phase, ...targets]),
    },
  });
  const drags = new Drags(store, solver as unknown as SolverClient);
  const ended = (id: number) => solver.emit('dragEnded', { type: 'dragEnded', id });
  return { drags, ended, sent, store };
}

test('a drag that the solver has refused or ended is over, and its end changes no target', () => {
  const { drags, ended, sent, store } = dragsOfOne();
  const drag = drags.hold(constrain, 3);
  drag.move(5, 0);
  assert.deepEqual(handlesNow(store.get())[0].target, [6, 2, 3]);
  ended(drag.id + 1);
  assert.equal(drag.isOver, false);
  ended(drag.id);
  assert.deepEqual(handlesNow(store.get()), [HANDLE]);
  drag.move(9, 0);
  drag.end();
  assert.deepEqual(handlesNow(store.get()), [HANDLE]);
  assert.deepEqual([store.get().dragged, store.get().moved], [[], null]);
  assert.deepEqual(
    sent.map(([, phase]) => phase),
    ['start', 'move'],
  );
});

test('a drag ends a typed move that is under way, and begins at its target', async () => {
  // The timer of the typed one ended the drag of the pointer, at the typed target.
  const { drags, sent } = dragsOfOne();
  const typed = drags.begin([{ ...HANDLE, target: [1, 2, 3] }]);
  typed.moveTo(Float64Array.of(1, 2, 7));
  const drag = drags.hold(constrain, 3);
  await typed.ended;
  typed.end();
  drag.move(1, 0);
  assert.equal(drag.end(), true);
  assert.deepEqual(sent, [
    [1, 'start'],
    [1, 'move', 1, 2, 7],
    [1, 'end', 1, 2, 7],
    [2, 'start'],
    [2, 'move', 2, 2, 7],
    [2, 'end', 2, 2, 7],
  ]);
});
