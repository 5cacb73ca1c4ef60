/**
 * Dragging handles: in the plane parallel to the screen through the handle. Of handles that are
 * selected together, all move alike.
 *
 * The plane is the one at the start of the drag. Points of it are affine in the pointer's place, so
 * three of them are asked for once; a plane that followed the vertex would drift with it.
 */

/** Pixels between the points that give the plane. */
const SPAN = 100;

export class HandleDrag {
  #store;
  #solver;
  #vertices;
  /** Where the handles were, `#vertices by 3`. */
  #from;
  /** Where they are dragged to. @type {Float64Array} */
  #targets;
  /** The pointer at the start. @type {[number, number]} */
  #start;
  /** Displacements per pixel to the right and per pixel down. @type {[number[], number[]]} */
  #perPixel;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("./solver-client.js").SolverClient} solver
   * @param {Pick<import("./pkg/view/shape_up.js").View, "dragTarget">} view
   * @param {number} vertex the handle under the pointer
   * @param {number} x of the pointer, CSS pixels within the viewport
   * @param {number} y
   */
  constructor(store, solver, view, vertex, x, y) {
    this.#store = store;
    this.#solver = solver;
    const { document, selection } = store.get();
    const together = (document?.handles ?? []).filter((handle) =>
      selection.vertices.has(vertex)
        ? selection.vertices.has(handle.vertex)
        : handle.vertex === vertex,
    );
    this.#vertices = Uint32Array.from(together, (handle) => handle.vertex);
    this.#from = Float64Array.from(together.flatMap((handle) => handle.target));
    this.#targets = this.#from;
    this.#start = [x, y];
    const origin = view.dragTarget(vertex, x, y, 0, 0);
    const right = view.dragTarget(vertex, x + SPAN, y, 0, 0);
    const down = view.dragTarget(vertex, x, y + SPAN, 0, 0);
    const perPixel = (/** @type {Float64Array} */ to) =>
      Array.from(to, (value, axis) => (value - origin[axis]) / SPAN);
    this.#perPixel = [perPixel(right), perPixel(down)];
    store.set({ dragged: [...this.#vertices] });
    this.#tell('start');
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  move(x, y) {
    const [right, down] = this.#perPixel;
    const dx = x - this.#start[0];
    const dy = y - this.#start[1];
    this.#targets = this.#from.map((value, i) => value + right[i % 3] * dx + down[i % 3] * dy);
    this.#show();
    this.#tell('move');
  }

  end() {
    this.#tell('end');
    this.#store.set({ dragged: [] });
  }

  /** Puts everything back to where it was. */
  cancel() {
    this.#targets = this.#from;
    this.#show();
    this.#tell('cancel');
    this.#store.set({ dragged: [] });
  }

  /** The dots follow the pointer at once; the mesh when the solver answers. */
  #show() {
    const { document } = this.#store.get();
    if (!document) return;
    const place = new Map([...this.#vertices].map((vertex, i) => [vertex, i]));
    const handles = document.handles.map((handle) => {
      const i = place.get(handle.vertex);
      if (i === undefined) return handle;
      const [x, y, z] = this.#targets.subarray(3 * i, 3 * i + 3);
      return { ...handle, target: /** @type {[number, number, number]} */ ([x, y, z]) };
    });
    this.#store.set({ document: { ...document, handles } });
  }

  /** @param {"start" | "move" | "end" | "cancel"} phase */
  #tell(phase) {
    const vertices = this.#vertices.slice();
    const targets = this.#targets.slice();
    this.#solver.tell({ type: 'drag', vertices, targets, phase });
  }
}
