// How clicks and regions change the selection.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  NOTHING,
  combineOf,
  describe,
  existing,
  select,
  verticesOf,
} from '../../../www/store/selection.ts';
import { Selecting } from '../../../www/store/mesh-queries.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { Operation } from '../../../www/pkg/engine/shape_up.js';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Actions } from '../../../www/store/actions.ts';

/** What a click does with these keys held. */
const withKeys = (held: Partial<Parameters<typeof combineOf>[0]>) =>
  combineOf({ shiftKey: false, ctrlKey: false, metaKey: false, ...held });

test('Shift adds, Ctrl removes, and a plain click replaces', () => {
  assert.equal(withKeys({ shiftKey: true }), 'add');
  assert.equal(withKeys({ ctrlKey: true, shiftKey: true }), 'remove');
  assert.equal(withKeys({ metaKey: true }), 'remove', 'Cmd on a Mac');
  assert.equal(withKeys({}), 'replace');
  const none = { shiftKey: false, ctrlKey: false, metaKey: false };
  assert.equal(combineOf(none, true), 'add', 'a finger, once that is asked for');
  const two = select(select(NOTHING, 'faces', [4], 'replace'), 'faces', [5], 'add');
  assert.deepEqual([...two.faces], [4, 5]);
  assert.deepEqual([...select(two, 'faces', [4], 'remove').faces], [5]);
  const vertex = select(two, 'vertices', [1], 'replace');
  assert.deepEqual([[...vertex.vertices], [...vertex.faces]], [[1], []]);
});

const square = {
  faceOffsets: Uint32Array.of(0, 4),
  faceIndices: Uint32Array.of(0, 1, 2, 3),
  untouchedOffsets: Uint32Array.of(0),
  untouchedIndices: new Uint32Array(0),
  unplaced: new Uint32Array(0),
  curveOffsets: Uint32Array.of(0),
  curveIndices: Uint32Array.of(),
  edges: Uint32Array.of(2, 9),
};

test('elements that a mesh does not have are left out', () => {
  // A face without corners stood for all of them.
  const mesh = { connectivity: square, positions: new Float64Array(12) };
  const asked = { vertices: [3, 4], edges: [0, 1], faces: [0, 900] };
  assert.deepEqual(existing(asked, mesh), { vertices: [3], edges: [0], faces: [0] });
  assert.deepEqual(existing(asked, null), { vertices: [], edges: [], faces: [] });
});

test('selected faces and edges stand for their vertices, each listed once', () => {
  const selection = { vertices: new Set([3]), edges: new Set([0]), faces: new Set([0]) };
  assert.deepEqual(verticesOf(selection, square), [0, 1, 2, 3, 9]);
  assert.equal(describe(selection), '1 vertex, 1 edge, 1 face');
});

test('a double-click on an element asks nothing about a mesh that comes meanwhile', async () => {
  // The edge with its number was selected there, or the number was out of range.
  const store = createStore();
  const open = () => store.set({ model: {} as State['model'] });
  open();
  const again = { id: 'wide' } as Operation;
  const loop = { id: 'loop', doubleClick: 'edges', again: 'wide' } as unknown as Operation;
  store.set({ operations: [loop, again] });
  const asked: string[] = [];
  let settled = async () => {};
  const solver = {
    begin: (begun: unknown) => begun,
    settled: () => settled(),
    ask: {
      async select({ operation }: { operation: string }) {
        asked.push(operation);
        return { vertices: [], edges: [7], faces: [] };
      },
    },
  };
  const actions = { setStatus() {}, reportErrors: (result: unknown) => result };
  const selecting = new Selecting(
    store,
    solver as unknown as SolverClient,
    actions as unknown as Actions,
  );
  const doubleClick = async () => {
    selecting.doubleClick('edges', 7, {} as MouseEvent);
    await new Promise((done) => setTimeout(done));
  };
  await doubleClick();
  settled = async () => open();
  await doubleClick();
  assert.deepEqual(asked, ['loop']);
});
