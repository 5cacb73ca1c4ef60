// Alt and a press make a vertex a handle, which is dragged at once.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { Drags } from '../../../www/store/handles.ts';
import { createStore } from '../../../www/store/state.ts';
import { PointerInput } from '../../../www/viewport/input/pointer.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { WorkerEvents } from '../../../www/solver/events.ts';
import type { Drag } from '../../../www/solver/types.ts';

const VERTEX = 5;
const ALT = { altKey: true, button: 0, buttons: 1, pointerId: 1, pointerType: 'mouse' };

globalThis.window = { addEventListener() {} } as unknown as typeof window;
globalThis.PointerEvent = class {} as unknown as typeof PointerEvent;

/** Pointer input on a view in which the pointer is always at the vertex. */
function inputAtVertex() {
  const store = createStore();
  /** Drags that were sent: phase, vertices, and targets along the screen. */
  const sent: (string | number)[][] = [];
  const drag = ({ phase, vertices, targets }: Drag) =>
    sent.push([phase, ...vertices, ...targets.filter((_, i) => i % 3 === 0)]);
  const solver = Object.assign(new Emitter<Pick<WorkerEvents, 'document' | 'model'>>(), {
    tell: { drag },
    geometry: { positions: new Float64Array(3 * (VERTEX + 1)).fill(100) },
  });
  solver.on('document', ({ document }) => store.set({ document }));
  const listeners: Record<string, (event: object) => void> = {};
  const dataset: DOMStringMap = {};
  const element = {
    ...{ dataset, focus() {}, setPointerCapture() {}, toggleAttribute() {} },
    addEventListener: (type: string, listener: (event: object) => void) =>
      (listeners[type] = listener),
    getBoundingClientRect: () => ({ left: 0, top: 0 }),
  };
  const view = {
    pickGizmo: () => undefined,
    pickHandle: () => undefined,
    pickVertex: () => VERTEX,
    holdVertex() {},
  };
  const constrainMove = (_: string, dx: number, dy: number) => Float64Array.of(dx, dy, 0);
  const within = (action: (shown: typeof view) => unknown) => action(view);
  const viewport = { element, view, with: within, constrainMove };
  const region = { paints: false, hide() {} };
  const drags = new Drags(store, solver as unknown as SolverClient);
  const given = [store, solver, viewport, region, { drags }, {}] as unknown;
  new PointerInput(...(given as ConstructorParameters<typeof PointerInput>));
  const event = (type: string, clientX: number, more: object = {}) =>
    listeners[type]({ ...ALT, ...{ type, clientX, clientY: 0, timeStamp: 0 }, ...more });
  /** The solver says that these vertices are handles. */
  const say = (...vertices: number[]) => {
    const handles = vertices.map((vertex) => ({ vertex, target: [0, 0, 0], fixed: false }));
    solver.emit('document', { document: { handles } } as WorkerEvents['document']);
  };
  const another = () => solver.emit('model', {} as WorkerEvents['model']);
  return { another, element, event, say, sent };
}

test('a new handle is dragged from where the vertex is shown, however late the solver makes it', () => {
  // A drag that ended before the solver had made the handle moved nothing.
  const { element, event, say, sent } = inputAtVertex();
  event('pointerdown', 10);
  event('pointermove', 14);
  say(1);
  assert.equal(element.dataset.gesture, 'handle');
  event('pointerup', 20);
  say(1, VERTEX);
  assert.deepEqual(sent, [
    ['make', VERTEX],
    ['move', VERTEX, 104],
    ['move', VERTEX, 110],
    ['end', VERTEX, 110],
  ]);
});

test('a press alone makes a handle at the vertex, wherever the solver has it by then', () => {
  const { element, event, say, sent } = inputAtVertex();
  event('pointerdown', 10);
  event('pointerup', 10);
  say(VERTEX);
  assert.equal(element.dataset.gesture, '');
  assert.deepEqual(sent, [
    ['make', VERTEX],
    ['end', VERTEX],
  ]);
});

test('a handle of another model that was opened meanwhile is not dragged', () => {
  const { another, event, say, sent } = inputAtVertex();
  event('pointerdown', 10);
  another();
  say(VERTEX);
  event('pointermove', 20);
  event('pointerup', 20);
  assert.deepEqual(sent, [['make', VERTEX]]);
});

test('a second finger on the view neither moves, ends nor cancels the drag of a handle', () => {
  const { element, event, say, sent } = inputAtVertex();
  event('pointerdown', 10);
  say(VERTEX);
  event('pointermove', 20);
  const before = sent.length;
  const finger = { pointerId: 2, pointerType: 'touch', altKey: false };
  event('pointerdown', 300, finger);
  event('pointermove', 310, finger);
  event('pointercancel', 310, finger);
  event('pointerdown', 300, finger);
  event('pointerup', 300, finger);
  assert.equal(sent.length, before);
  assert.equal(element.dataset.gesture, 'handle');
  event('pointerup', 20);
  assert.deepEqual(sent.at(-1), ['end', VERTEX, 110]);
});
