/**
 * Dragging handles: in the plane parallel to the screen through the handle, at its height, or along
 * an axis. Of handles that are selected together, all move alike.
 *
 * The plane is the one at the start of the drag. Points of it are affine in the pointer's place, so
 * three of them are asked for once; a plane that followed the vertex would drift with it.
 */

/** Pixels between the points that give the plane. */
const SPAN = 100;
/** The sine of the angle below which a plane is seen from its side. */
const EDGE_ON = 0.1;

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
  /** Where the pointer was last. @type {[number, number]} */
  #last;
  /** @type {"screen" | "horizontal" | "vertical"} */
  #plane = 'screen';
  /** The axis that the handle stays on, if any: 0, 1, 2. @type {number | null} */
  #axis = null;
  #up;
  /** Displacements per pixel to the right and per pixel down. @type {[number[], number[]]} */
  #perPixel;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("./solver-client.js").SolverClient} solver
   * @param {Pick<import("./pkg/view-webgl2/shape_up.js").View, "dragTarget">} view
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
    this.#start = this.#last = [x, y];
    this.#up = document?.up === 'y' ? 1 : 2;
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
    this.#last = [x, y];
    const way = this.#way(x - this.#start[0], y - this.#start[1]);
    this.#targets = this.#from.map((value, i) => value + way[i % 3]);
    this.#show();
    this.#tell('move');
  }

  /** What a drag with these keys moves in. @param {"screen" | "horizontal" | "vertical"} plane */
  hold(plane) {
    this.#plane = plane;
  }

  /** Keeps the handles on lines along an axis, or lets them go from it. @param {number} axis 0, 1, 2 */
  toggleAxis(axis) {
    this.#axis = this.#axis === axis ? null : axis;
    this.move(...this.#last);
  }

  /**
   * The displacement that follows a pointer's way as well as it is allowed to.
   * @param {number} dx pixels to the right
   * @param {number} dy pixels down
   * @returns {number[]}
   */
  #way(dx, dy) {
    const [right, down] = this.#perPixel;
    const free = right.map((part, axis) => part * dx + down[axis] * dy);
    const axis = this.#axis ?? (this.#plane === 'vertical' ? this.#up : null);
    if (axis !== null) {
      const [along] = this.#onScreen([axis]);
      const length = along[0] ** 2 + along[1] ** 2;
      const far = length > 0 ? (along[0] * dx + along[1] * dy) / length : 0;
      return free.map((_, i) => (i === axis ? far : 0));
    }
    if (this.#plane === 'horizontal') {
      const axes = [0, 1, 2].filter((i) => i !== this.#up);
      const [a, b] = this.#onScreen(axes);
      const turn = a[0] * b[1] - a[1] * b[0];
      const sizes = Math.hypot(...a) * Math.hypot(...b);
      // Seen from the side, a plane is a line: what is up on the screen says nothing of it.
      if (Math.abs(turn) < EDGE_ON * sizes)
        return free.map((part, i) => (i === this.#up ? 0 : part));
      const way = [0, 0, 0];
      way[axes[0]] = (dx * b[1] - dy * b[0]) / turn;
      way[axes[1]] = (a[0] * dy - a[1] * dx) / turn;
      return way;
    }
    return free;
  }

  /** How many pixels to the right and down a unit along each axis is. @param {number[]} axes */
  #onScreen(axes) {
    return axes.map((axis) =>
      this.#perPixel.map((way) => way[axis] / way.reduce((sum, part) => sum + part * part, 0)),
    );
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
