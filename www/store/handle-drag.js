/**
 * Dragging handles: on the screen, at constant height, along an axis, in a plane. Handles that are
 * selected together move alike. The view computes the displacement from the pointer.
 */

import { handlesNow } from './state.js';

const AXES = ['x', 'y', 'z'];

/**
 * Returns the displacement of the held handle for one of the pointer in pixels; undefined if none.
 * @typedef {(direction: string, dx: number, dy: number) => Float64Array | undefined} MoveConstraint
 */

export class HandleDrag {
  #store;
  #solver;
  #constrain;
  #vertices;
  /** Targets of the handles at the start, `#vertices by 3`. */
  #from;
  /** Current targets. @type {Float64Array} */
  #targets;
  /** Displacement of the pointer since the start. @type {[number, number]} */
  #by = [0, 0];
  /** The axis or plane of the gizmo being dragged. */
  #part;
  #plane = 'screen';
  /** The axis to which a key restricts the handle: 0, 1, 2 or none. @type {number | null} */
  #axis = null;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("../solver/solver-client.js").SolverClient} solver
   * @param {MoveConstraint} constrain
   * @param {number} vertex the handle under the pointer, or one of those at the gizmo
   * @param {string} [part] of the gizmo
   * @param {boolean} [begun] whether the solver has already begun a drag
   */
  constructor(store, solver, constrain, vertex, part, begun = false) {
    this.#store = store;
    this.#solver = solver;
    this.#constrain = constrain;
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
    // A message about a finished run is outdated.
    store.set({ dragged: [...this.#vertices], gizmoPart: part, status: '' });
    if (!begun) this.#send('start');
  }

  /**
   * @param {number} dx pixels to the right since the beginning
   * @param {number} dy pixels down
   * @param {number} [time] of the event, on the clock of `performance.now()`
   */
  move(dx, dy, time = performance.now()) {
    this.#by = [dx, dy];
    const direction = this.#axis !== null ? AXES[this.#axis] : (this.#part ?? this.#plane);
    const moved = this.#constrain(direction, dx, dy);
    // Near the horizon of the plane a pixel is arbitrarily far: the handle stays.
    if (!moved) return;
    this.#targets = this.#from.map((value, i) => value + moved[i % 3]);
    // The dots follow the pointer at once, the mesh when the solver answers.
    this.#store.set({ moved: { by: [...moved], targets: this.#targets }, gizmoPart: direction });
    this.#send('move', time);
  }

  /** Sets the plane of the drag. @param {"screen" | "horizontal" | "vertical"} plane */
  setPlane(plane) {
    this.#plane = plane;
  }

  /** Toggles a restriction of the handles to an axis. @param {number} axis 0, 1, 2 */
  toggleAxis(axis) {
    this.#axis = this.#axis === axis ? null : axis;
    this.move(...this.#by);
  }

  end() {
    this.#send('end');
    const { document } = this.#store.get();
    // Valid until the solver sends the new document.
    if (document)
      this.#store.set({ document: { ...document, handles: handlesNow(this.#store.get()) } });
    this.#leave();
  }

  /** Cancels the drag and restores the targets. */
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
 * Makes a vertex a handle, which may then be dragged, as one step of undo.
 * @param {import("./state.js").Store} store
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {number} vertex
 */
export function makeHandle(store, solver, vertex) {
  sendOfNew(solver, [vertex], 'make');
  store.set({ dragged: [vertex] });
}

/**
 * Ends or cancels a handle that was made but not dragged.
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
