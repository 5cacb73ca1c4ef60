/**
 * Dragging handles: on the screen, at their height, along an axis, in a plane. Of handles that are
 * selected together, all move alike. The view says where the pointer leads what it holds.
 */

import { handlesNow } from './state.js';

const AXES = ['x', 'y', 'z'];

/**
 * How far what is held goes for a pointer that has gone by so many pixels; nothing where that cannot
 * be said.
 * @typedef {(way: string, dx: number, dy: number) => Float64Array | undefined} Hold
 */

export class HandleDrag {
  #store;
  #solver;
  #hold;
  #vertices;
  /** Where the handles were, `#vertices by 3`. */
  #from;
  /** Where they are dragged to. @type {Float64Array} */
  #targets;
  /** How far the pointer has gone. @type {[number, number]} */
  #by = [0, 0];
  /** The axis or plane of the gizmo that was taken. */
  #part;
  #plane = 'screen';
  /** The axis that the handle stays on by key, if any: 0, 1, 2. @type {number | null} */
  #axis = null;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("../solver/solver-client.js").SolverClient} solver
   * @param {Hold} hold
   * @param {number} vertex the handle under the pointer, or one of those at the gizmo
   * @param {string} [part] of the gizmo
   * @param {boolean} [begun] the solver knows that something is dragged
   */
  constructor(store, solver, hold, vertex, part, begun = false) {
    this.#store = store;
    this.#solver = solver;
    this.#hold = hold;
    this.#part = part;
    const { document, selection } = store.get();
    const together = (document?.handles ?? []).filter((handle) =>
      selection.vertices.has(vertex)
        ? selection.vertices.has(handle.vertex)
        : handle.vertex === vertex,
    );
    this.#vertices = Uint32Array.from(together, (handle) => handle.vertex);
    this.#from = Float64Array.from(together.flatMap((handle) => handle.target));
    this.#targets = this.#from;
    // What was said of a run is no longer so.
    store.set({ dragged: [...this.#vertices], gizmoPart: part, status: '' });
    if (!begun) this.#send('start');
  }

  /**
   * @param {number} dx pixels to the right since the beginning
   * @param {number} dy pixels down
   * @param {number} [time] of the event, as `performance.now()` has it
   */
  move(dx, dy, time = performance.now()) {
    this.#by = [dx, dy];
    const way = this.#axis !== null ? AXES[this.#axis] : (this.#part ?? this.#plane);
    const moved = this.#hold(way, dx, dy);
    // Towards the horizon a pixel is any distance: the handle waits where it is.
    if (!moved) return;
    this.#targets = this.#from.map((value, i) => value + moved[i % 3]);
    // The dots follow the pointer at once; the mesh when the solver answers.
    this.#store.set({ moved: { by: [...moved], targets: this.#targets }, gizmoPart: way });
    this.#send('move', time);
  }

  /** What a drag with these keys moves in. @param {"screen" | "horizontal" | "vertical"} plane */
  hold(plane) {
    this.#plane = plane;
  }

  /** Keeps the handles on lines along an axis, or lets them go from it. @param {number} axis 0, 1, 2 */
  toggleAxis(axis) {
    this.#axis = this.#axis === axis ? null : axis;
    this.move(...this.#by);
  }

  end() {
    this.#send('end');
    const { document } = this.#store.get();
    // Until the solver sends the document as it is now.
    if (document)
      this.#store.set({ document: { ...document, handles: handlesNow(this.#store.get()) } });
    this.#leave();
  }

  /** Puts everything back to where it was. */
  cancel() {
    this.#targets = this.#from;
    this.#send('cancel');
    this.#leave();
  }

  #leave() {
    this.#store.set({ dragged: [], moved: null, gizmoPart: undefined });
  }

  /**
   * @param {"start" | "move" | "end" | "cancel"} phase
   * @param {number} [time]
   */
  #send(phase, time) {
    const vertices = this.#vertices.slice();
    const targets = this.#targets.slice();
    this.#solver.send({ type: 'drag', vertices, targets, phase, time });
  }
}

/**
 * Makes a vertex a handle, which may be dragged then: one step of undo.
 * @param {import("./state.js").Store} store
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {number} vertex
 */
export function makeHandle(store, solver, vertex) {
  sendOfNew(solver, [vertex], 'make');
  store.set({ dragged: [vertex] });
}

/**
 * What becomes of a handle that was made and has not been dragged.
 * @param {import("./state.js").Store} store
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {"end" | "cancel"} phase
 */
export function leaveHandle(store, solver, phase) {
  sendOfNew(solver, [], phase);
  store.set({ dragged: [] });
}

/**
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {number[]} vertices
 * @param {"make" | "end" | "cancel"} phase
 */
function sendOfNew(solver, vertices, phase) {
  const targets = new Float64Array(0);
  solver.send({ type: 'drag', vertices: Uint32Array.from(vertices), targets, phase });
}
