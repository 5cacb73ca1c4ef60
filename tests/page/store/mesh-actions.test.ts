// Refining by levels: when it waits for a run, goes on, and stops.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { Cancelled } from '../../../www/solver/errors.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { meshActions } from '../../../www/store/mesh-actions.ts';
import { createStore, type Store } from '../../../www/store/state.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Loaded } from '../../../www/solver/types.ts';
import type { Actions } from '../../../www/store/actions.ts';

/** Whether it runs, and whether it has converged. */
interface Activity {
  running: boolean;
  converged: boolean;
}

/** A solver that runs, and whose runs end only when the test says so. */
class RunningSolver extends Emitter<{ activity: Activity }> {
  store: Store;
  refinements = 0;

  constructor(store: Store) {
    super();
    this.store = store;
    this.#turn(true, false);
  }

  #turn(running: boolean, converged: boolean) {
    this.store.set({ running, converged });
    this.emit('activity', { running, converged });
  }

  readonly tell = {
    /** Ignored during a run. */
    run: () => {
      if (!this.store.get().running) this.#turn(true, false);
    },
  };

  readonly change = {
    editAndRun: async () => {
      this.refinements += 1;
      this.#turn(true, false);
    },
    edit: async () => {
      const model = { faces: 20, notes: ['Left out: a handle.'] } as unknown as Loaded;
      this.store.set({ model });
    },
  };

  async endRun(converged: boolean) {
    this.#turn(false, converged);
    await new Promise((done) => setTimeout(done));
  }
}

function refineDuringRun() {
  const store = createStore();
  const solver = new RunningSolver(store);
  const said: string[] = [];
  const actions = {
    setStatus: (words: string) => said.push(words),
    ask: { panelProgress: async () => undefined },
  };
  const told: string[] = [];
  const alerts = { notice: (words: string) => (told.push(words), () => {}) };
  const given = [solver as unknown as SolverClient, actions as unknown as Actions, alerts] as const;
  const how = { scheme: 'catmull-clark' as const, levels: 1, keep: 75 };
  const mesh = meshActions(store, ...given);
  return { store, solver, said, told, mesh, ended: mesh.refine(how, true) };
}

test('Refine and solve during a run refines when that run has converged', async () => {
  // It used to wait for the beginning of another run: the button stayed Pause.
  const { store, solver, ended } = refineDuringRun();
  await solver.endRun(true);
  assert.equal(solver.refinements, 1);
  await solver.endRun(true);
  await ended;
  assert.equal(store.get().refining, false);
});

test('Pause before the first level ends Refine and solve', async () => {
  for (const converged of [false, true]) {
    const { store, solver, ended } = refineDuringRun();
    store.set({ refining: false });
    await solver.endRun(converged);
    await ended;
    // A later run used to refine.
    solver.tell.run();
    await solver.endRun(true);
    assert.equal(solver.refinements, 0);
  }
});

test('Refine and solve says nothing about a model that is opened meanwhile', async () => {
  // It was said to be refined.
  const { store, solver, said, ended } = refineDuringRun();
  await solver.endRun(true);
  store.set({ model: { faces: 25 } as Loaded });
  const given = assert.rejects(ended, Cancelled);
  await solver.endRun(false);
  await given;
  assert.deepEqual(said, []);
  assert.equal(store.get().refining, false);
});

test('whoever changes the mesh, what is left out of the scene is told', async () => {
  // It was told by each caller: "Join them" told nothing.
  const { mesh, told } = refineDuringRun();
  await mesh.remesh({ operation: 'join', sizes: [] }, 'Join them');
  assert.deepEqual(told, ['Left out: a handle.']);
});

test('a second press on a repair, before the first is done, repairs nothing more', async () => {
  const { mesh, solver } = refineDuringRun();
  const edits = mock.method(solver.change, 'edit');
  const press = () => mesh.remesh({ operation: 'join', sizes: [] }, 'Join them');
  await Promise.all([press(), press()]);
  assert.equal(edits.mock.callCount(), 1);
  await press();
  assert.equal(edits.mock.callCount(), 2);
});
