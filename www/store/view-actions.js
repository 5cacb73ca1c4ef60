/** Actions on the display and the selection, which do not concern the solver. */

import { NOTHING } from './selection.js';

/** @typedef {import("./state.js").State} State */

/** @param {import("./state.js").Store} store */
export function createViewActions(store) {
  return {
    /** @param {string} status last event, as text */
    setStatus: (status) => store.set({ status }),

    /** @param {Partial<State["display"]>} change */
    display: (change) => store.set({ display: { ...store.get().display, ...change } }),

    /** Sets the measure that colours the faces. @param {State["measure"]} measure */
    colourBy: (measure) => store.set({ measure, measureChosen: true }),

    /** @param {Partial<State["ownRange"]>} change of the range of the colours */
    setRange: (change) =>
      store.set({ ownRange: { ...store.get().ownRange, top: null, ...change } }),

    /** Sets the tolerance of lengths, in the unit of the mesh. @param {number | null} tolerance */
    setTolerance: (tolerance) => store.set({ tolerance }),

    /**
     * Sets the tolerance of another measure, in its unit.
     * @param {string} id
     * @param {number | null} value
     */
    setToleranceOf: (id, value) =>
      store.set({ tolerances: { ...store.get().tolerances, [id]: value } }),

    /** @param {State["tint"]} tint */
    tint: (tint) => store.set({ tint }),

    /** @param {Partial<Pick<State, "tool" | "shape" | "through" | "brush" | "tape">>} tool */
    useTool: (tool) => store.set(tool),

    /**
     * Sets parts of the display.
     * @param {Partial<Pick<State, "parallel" | "split" | "flatMap" | "heldOriginal" | "build" | "status" |
     *   "renderer" | "camera" | "section" | "views" | "tab" | "measure" | "measureChosen" | "tolerance" | "tolerances">>} look
     */
    look: (look) => store.set(look),

    /** Sets what the pointer is over. @param {Pick<State, "gizmoPart" | "pointedAt">} over */
    pointAt: (over) => store.set(over),

    /**
     * Sets the source and the save status of the model.
     * @param {Partial<Pick<State, "firstExample" | "fileName" | "example" | "isNew" | "saved" | "status">>} file
     */
    describeFile: (file) => store.set(file),

    /**
     * Selects only the faces if there are any, else the edges, else the vertices.
     * @param {{ vertices: Iterable<number>, edges?: Iterable<number>, faces: Iterable<number> }} elements
     */
    select({ vertices, edges = [], faces }) {
      const sets = { faces: new Set(faces), edges: new Set(edges), vertices: new Set(vertices) };
      const mode = sets.faces.size > 0 ? 'faces' : sets.edges.size > 0 ? 'edges' : 'vertices';
      store.set({ mode, selection: { ...NOTHING, [mode]: sets[mode] } });
    },

    /** @param {State["selection"]} selection */
    setSelection: (selection) => store.set({ selection }),

    selectNothing: () => store.set({ selection: NOTHING }),
  };
}
