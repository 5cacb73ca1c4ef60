/** What the page can do to the mesh itself: it comes when somebody first asks. */

import { count, length } from '../../ui/format.js';

/** @typedef {import("../../pkg/solver/shape_up.js").Remeshing} Remeshing */
/** @typedef {Omit<Extract<import("../../solver/messages.js").Edit, { type: "refine" }>, "type">} Refinement */

/**
 * @param {import("../state.js").Store} store
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {import("../actions.js").Actions} actions
 */
export function meshActions(store, solver, actions) {
  /** Begins a run, and settles when it has ended: whether nobody has stopped it. @param {() => unknown} begin */
  async function untilEnd(begin) {
    /** @type {() => void} */
    let stop = () => {};
    const ended = new Promise((settle) => {
      let began = false;
      stop = solver.on('activity', ({ running, converged }) => {
        began ||= running;
        if (began && !running) settle(converged);
      });
    });
    try {
      await begin();
      return await ended;
    } finally {
      stop();
    }
  }

  /** How near the panels are to what they are asked to be, for the status line. */
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
    /** The operations that there are, with sizes that fit the mesh. */
    operations: () => solver.request({ type: 'meshOperations' }),

    /** What an operation would make of the mesh. @param {Remeshing} asked */
    remeshing: (asked) => solver.request({ type: 'remeshing', asked }),

    /** Does an operation. @param {Remeshing} asked @param {string} label @returns {Promise<string[]>} what is lost */
    async remesh(asked, label) {
      const { faces: before = 0 } = store.get().model ?? {};
      await solver.request({ type: 'edit', edit: { type: 'remesh', ...asked } });
      const { model } = store.get();
      actions.setStatus(
        `${label}: ${count(before, 'face')} became ${count(model?.faces ?? 0, 'face')}`,
      );
      return model?.notes ?? [];
    },

    /** What refining would make of the mesh, once, twice and so on. @param {Refinement["scheme"]} scheme @param {number} keep */
    refinements: (scheme, keep) => solver.request({ type: 'refinements', scheme, keep }),

    /**
     * Refines; or solves, refines once and solves again until it is refined so often or somebody pauses.
     * @param {Refinement} how
     * @param {boolean} solves
     * @returns {Promise<string[]>} what could not be carried over
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
        for (let level = 1; level <= how.levels && goesOn; level++) {
          const ended = await untilEnd(() => solver.request({ type: 'editAndRun', edit: once }));
          const words = `${refined()}${await verdict()}`;
          // Between two levels nothing runs: there too somebody can pause.
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
