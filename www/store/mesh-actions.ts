/** Actions on the mesh itself, which tell what of the scene was left out. */

import { endOfRun } from './end-of-run.ts';
import { Cancelled } from '../solver/errors.ts';
import { oneAtATime } from '../ui/once.ts';
import { count } from '../ui/words.ts';
import type { LaidOut, Remeshing, Edit } from '../pkg/engine/shape_up.js';
import type { Store } from './state.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Alerts } from '../ui/controls/alerts.tsx';
import type { Actions } from './actions.ts';

type Refinement = Extract<Edit, { refine: unknown }>['refine'];

export function meshActions(
  store: Store,
  solver: SolverClient,
  actions: Actions,
  alerts: Pick<Alerts, 'notice'>,
) {
  /** What could not be transferred to the mesh as it is now. */
  const leftOut = () => store.get().model?.notes ?? [];

  function tell(lost: string[]) {
    if (lost.length > 0) alerts.notice(lost.join(' '));
  }

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
    /** Performs an operation; nothing while one is under way, as a second press of its button would. */
    remesh: oneAtATime(async (asked: Remeshing, label: string) => {
      const { faces: before = 0 } = store.get().model ?? {};
      await solver.change.edit({ remesh: asked });
      const { faces: after = 0 } = store.get().model ?? {};
      actions.setStatus(`${label}: ${count(before, 'face')} became ${count(after, 'face')}`);
      tell(leftOut());
    }),

    /**
     * Puts panels that were laid out in place of the mesh.
     * @returns whether they were for the current model
     */
    async takePanels(generation: number, panels: LaidOut) {
      const taken = await solver.change.takePanels(generation, panels);
      if (!taken) return false;
      tell(leftOut());
      actions.setStatus(panels.words);
      return true;
    },

    /**
     * Refines; or alternately solves and refines once, until all levels are done or the user stops.
     */
    async refine(how: Refinement, solves: boolean) {
      const lost: string[] = [];
      const refined = () => {
        lost.push(...leftOut());
        return `Refined to ${count(store.get().model?.faces ?? 0, 'face')}`;
      };
      if (!solves) {
        await solver.change.edit({ refine: how });
        actions.setStatus(refined());
        return tell(lost);
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
      tell(lost);
    },
  };
}

export type MeshActions = ReturnType<typeof meshActions>;
