/** Actions on the mesh itself. */

import { endOfRun } from './end-of-run.ts';
import { Cancelled } from '../solver/errors.ts';
import { count } from '../ui/words.ts';
import type { Remeshing } from '../pkg/engine/shape_up.js';
import type { Edit } from '../solver/types.ts';
import type { Store } from './state.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Actions } from './actions.ts';

type Refinement = Extract<Edit, { refine: unknown }>['refine'];

export function meshActions(store: Store, solver: SolverClient, actions: Actions) {
  /** What is found about the open mesh; rejects if another one is open by then. */
  async function ofThisMesh<Found>(found: Promise<Found>): Promise<Found> {
    const { model } = store.get();
    const value = await found;
    if (store.get().model !== model) throw new Cancelled();
    return value;
  }

  /** Runs to the end; false if stopped before convergence. */
  async function untilEnd(begin: () => unknown) {
    // A current run goes on, and is waited for.
    const { ended, stop } = endOfRun(solver, store.get().running);
    try {
      await begin();
    } catch (error) {
      stop();
      throw error;
    }
    return ofThisMesh(ended);
  }

  /** The verdict on the panels, for the status line. */
  async function verdict() {
    const found = await ofThisMesh(actions.ask.panelProgress());
    return found ? `. ${found}` : '';
  }

  return {
    /**
     * Performs an operation.
     * @returns what was lost
     */
    async remesh(asked: Remeshing, label: string): Promise<string[]> {
      const { faces: before = 0 } = store.get().model ?? {};
      await solver.change.edit({ remesh: asked });
      const { model } = store.get();
      actions.setStatus(
        `${label}: ${count(before, 'face')} became ${count(model?.faces ?? 0, 'face')}`,
      );
      return model?.notes ?? [];
    },

    /**
     * Refines; or alternately solves and refines once, until all levels are done or the user stops.
     * @returns what could not be transferred
     */
    async refine(how: Refinement, solves: boolean): Promise<string[]> {
      const lost: string[] = [];
      const refined = () => {
        const { model } = store.get();
        lost.push(...(model?.notes ?? []));
        return `Refined to ${count(model?.faces ?? 0, 'face')}`;
      };
      if (!solves) {
        await solver.change.edit({ refine: how });
        actions.setStatus(refined());
        return lost;
      }
      const once: Edit = { refine: { ...how, levels: 1 } };
      store.set({ refining: true });
      try {
        let goesOn = store.get().converged || (await untilEnd(() => solver.tell.run()));
        goesOn &&= store.get().refining;
        for (let level = 1; level <= how.levels && goesOn; level++) {
          const ended = await untilEnd(() => solver.change.editAndRun(once));
          const words = refined();
          const told = await verdict();
          // The user may also have paused between two levels, when nothing runs.
          goesOn = ended && (level === how.levels || store.get().refining);
          actions.setStatus(`${words}${goesOn ? '' : '; stopped'}${told}`);
        }
      } finally {
        store.set({ refining: false });
      }
      return lost;
    },
  };
}
