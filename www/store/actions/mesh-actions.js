/** Actions on the mesh itself. Loaded on first use. */

import { count, length } from '../../ui/format.js';

/** @typedef {import("../../pkg/engine/shape_up.js").Remeshing} Remeshing */
/** @typedef {Omit<Extract<import("../../solver/messages.js").Edit, { type: "refine" }>, "type">} Refinement */

/**
 * @param {import("../state.js").Store} store
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {import("../actions.js").Actions} actions
 */
export function meshActions(store, solver, actions) {
  /** Runs to the end; false if stopped before convergence. @param {() => unknown} begin */
  async function untilEnd(begin) {
    // A current run goes on, and is waited for.
    let began = store.get().running;
    const ended = new Promise((settle) => {
      const stop = solver.on('activity', ({ running, converged }) => {
        began ||= running;
        if (running || !began) return;
        stop();
        settle(converged);
      });
    });
    await begin();
    return ended;
  }

  /** Summarises the panels' distances from their constraints, for the status line. */
  async function verdict() {
    const { tolerance, model, document } = store.get();
    const within = tolerance ?? model?.tolerance ?? 0;
    const found = await actions.verdict(within);
    if (!found) return '';
    const [worst, limit] = [found.worst, found.tolerance].map((far) =>
      length(far, document?.units ?? ''),
    );
    return `, ${found.within} of ${found.panels} panels ${found.adjective} within ${limit}, the worst ${worst}`;
  }

  return {
    /** Returns the available operations, with sizes that fit the mesh. */
    operations: () => solver.request({ type: 'meshOperations' }),

    /** Previews the result of an operation. @param {Remeshing} asked */
    remeshing: (asked) => solver.request({ type: 'remeshing', asked }),

    /**
     * Performs an operation.
     * @param {Remeshing} asked
     * @param {string} label
     * @returns {Promise<string[]>} what was lost
     */
    async remesh(asked, label) {
      const { faces: before = 0 } = store.get().model ?? {};
      await solver.request({ type: 'edit', edit: { type: 'remesh', ...asked } });
      const { model } = store.get();
      actions.setStatus(
        `${label}: ${count(before, 'face')} became ${count(model?.faces ?? 0, 'face')}`,
      );
      return model?.notes ?? [];
    },

    /**
     * Previews the result of refining once, twice and so on.
     * @param {Refinement["scheme"]} scheme
     * @param {number} keep
     */
    refinements: (scheme, keep) => solver.request({ type: 'refinements', scheme, keep }),

    /**
     * Refines; or alternately solves and refines once, until all levels are done or the user stops.
     * @param {Refinement} how
     * @param {boolean} solves
     * @returns {Promise<string[]>} what could not be transferred
     */
    async refine(how, solves) {
      /** @type {string[]} */
      const lost = [];
      const refined = () => {
        const { model } = store.get();
        lost.push(...(model?.notes ?? []));
        return `Refined to ${count(model?.faces ?? 0, 'face')}`;
      };
      if (!solves) {
        await solver.request({ type: 'edit', edit: { type: 'refine', ...how } });
        actions.setStatus(refined());
        return lost;
      }
      /** @type {import("../../solver/messages.js").Edit} */
      const once = { type: 'refine', ...how, levels: 1 };
      store.set({ refining: true });
      try {
        let goesOn = store.get().converged || (await untilEnd(() => solver.send({ type: 'run' })));
        goesOn &&= store.get().refining;
        for (let level = 1; level <= how.levels && goesOn; level++) {
          const ended = await untilEnd(() => solver.request({ type: 'editAndRun', edit: once }));
          const words = `${refined()}${await verdict()}`;
          // The user may also have paused between two levels, when nothing runs.
          goesOn = ended && (level === how.levels || store.get().refining);
          actions.setStatus(goesOn ? words : `${words}; stopped`);
        }
      } finally {
        store.set({ refining: false });
      }
      return lost;
    },
  };
}
