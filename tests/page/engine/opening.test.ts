// What the worker opens: how many faces that may have, and which numbers its constraints keep.

import assert from 'node:assert/strict';
import { before, test, type TestContext } from 'node:test';
import init, { Solver } from '../../../www/pkg/engine/shape_up.js';
import type { FromWorker } from '../../../www/solver/events.ts';
import { open } from '../../../www/worker/open.ts';
import { Scheduler } from '../../../www/worker/scheduler.ts';

const named = (name: string, text: string) => ({ name, bytes: new TextEncoder().encode(text) });
const positions = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0.2],
  [0, 1, 0],
];
const corners = positions.map((place) => `v ${place.join(' ')}\n`).join('');
/** A bent quad as two triangles. */
const obj = named('bent.obj', `${corners}f 1 2 3\nf 1 3 4\n`);
const beside = named('beside.json', sceneText({ file: 'bent.obj' }));
const inline = named('inline.json', sceneText({ positions, faces: [[0, 1, 2, 3]] }));

function sceneText(mesh: object) {
  const constraints = ['plane', 'circle'].map((kind) => ({ kind, on: 'faces' }));
  return JSON.stringify({ format: 'shape-up-scene', version: 1, units: 'm', mesh, constraints });
}

before(() =>
  init({
    module_or_path: new URL('../../../www/pkg/engine/shape_up_bg.wasm', import.meta.url),
  }),
);

/** The solver does not die in these tests. */
const died = (thrown: unknown) => assert.fail(thrown as Error);

/** A worker without a model, and the messages that it sends. */
function worker(context: TestContext) {
  // Node does not exit while one is open.
  const channel = new MessageChannel();
  context.mock.method(globalThis, 'MessageChannel', function () {
    return channel;
  });
  context.after(() => channel.port1.close());
  const sent: FromWorker[] = [];
  const solver = new Solver();
  const scheduler = new Scheduler(solver, (message) => sent.push(message), died);
  return { solver, scheduler, sent };
}

test('more faces than allowed are counted, in a mesh and in a scene, and not opened', (context) => {
  const { solver, scheduler, sent } = worker(context);
  const opened = (files: (typeof obj)[], most?: number) => open(solver, scheduler, { files, most });
  assert.equal(opened([obj], 1), 2);
  assert.equal(opened([beside, obj], 1), 2);
  assert.equal(opened([inline], 0), 1);
  assert.deepEqual(sent, []);
  assert.throws(() => solver.scene(), /open/);
  for (const most of [undefined, 2]) {
    const loaded = opened([beside, obj], most);
    assert.equal(typeof loaded === 'object' && loaded.faces, 2);
  }
  // What was only counted is not opened later in place of something else.
  assert.equal(opened([inline], 0), 1);
  assert.throws(() => solver.openRead('inline.json', new Uint32Array(0)), /nothing has been read/);
  assert.equal(solver.document().constraints.length, 2);
});

test('constraints have the numbers that they had in the worker before', (context) => {
  const { solver, scheduler } = worker(context);
  const numbers = (rows: number[]) => {
    open(solver, scheduler, { files: [inline], rows });
    return solver.document().constraints.map(({ number }) => number);
  };
  assert.deepEqual(numbers([41, 7]), [41, 7]);
  // Those of another list say nothing of this one.
  assert.notDeepEqual(numbers([41, 7, 9]).slice(0, 2), [41, 7]);
});
