/**
 * Frames for the page: positions in two buffers that travel back and forth, and the other requested
 * data. Without a free buffer no frame is sent.
 */

/** @typedef {import("../solver/messages.js").FromWorker} FromWorker */
/** @typedef {Extract<import("../solver/messages.js").Command, { type: "show" }>} Show */

export class Frames {
  /** Whether the state has changed since the last frame. */
  due = false;
  /** @type {Omit<Show, "type">} */
  shown = { measure: null, shapes: false, projections: false, corners: false };

  #solver;
  #post;
  /** Buffers available for writing. @type {Float64Array[]} */
  #free = [];
  #length = 0;

  /**
   * @param {import("../pkg/engine/shape_up.js").Solver} solver
   * @param {(message: FromWorker, transfer?: Transferable[]) => void} post
   */
  constructor(solver, post) {
    this.#solver = solver;
    this.#post = post;
  }

  /**
   * Starts with another mesh.
   * @param {number} vertices
   * @returns {Float64Array} the first of the two buffers, filled with its positions
   */
  renew(vertices) {
    this.#length = 3 * vertices;
    this.#free = [new Float64Array(this.#length)];
    const positions = new Float64Array(this.#length);
    this.#solver.writePositions(positions);
    return positions;
  }

  /** Takes a buffer back, unless it is of the previous mesh. @param {Float64Array} positions */
  takeBack(positions) {
    if (positions.length === this.#length && this.#free.length < 2) this.#free.push(positions);
  }

  /**
   * Sends the state of the iteration, if it has changed and a buffer is free.
   * @param {() => [number, number] | null} answers the move of a drag that the frame shows
   * @param {boolean} iterating whether more frames follow
   * @returns {boolean} whether it was sent
   */
  send(answers, iterating) {
    const positions = this.#free.at(-1);
    if (!this.due || !positions) return false;
    const solver = this.#solver;
    const { measure, shapes, projections, corners } = this.shown;
    solver.writePositions(positions);
    const parts = {
      values: measure ? solver.faceValues(measure) : null,
      corners: (measure && corners && solver.cornerValues(measure)) || null,
      shapes: shapes ? solver.fitted() : null,
    };
    /** @type {import("../solver/messages.js").Projections | null} */
    const projected = projections ? solver.projections() : null;
    this.#free.pop();
    const arrays = [positions, ...Object.values(parts), ...Object.values(projected ?? {})];
    this.#post(
      {
        ...{ type: 'frame', numbers: solver.frame(iterating), positions, measure },
        ...{ ...parts, projections: projected, answers: answers() },
      },
      arrays.flatMap((array) => array?.buffer ?? []),
    );
    this.due = false;
    return true;
  }
}
