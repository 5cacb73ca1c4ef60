/** The way from one shape to another, that a press is seen to do something: the shapes between them. */

export class ShapeTransition {
  #from;
  #milliseconds;
  #mixed;
  /** The newest positions when it was made: it begins when they are others. */
  #first;
  #began = 0;
  /** From 0, where it began, to 1. */
  part = 0;

  /**
   * @param {Float64Array} from `#V by 3`; it may be overwritten afterwards
   * @param {number} milliseconds
   */
  constructor(from, milliseconds) {
    this.#first = from;
    this.#from = from.slice();
    this.#mixed = from.slice();
    this.#milliseconds = milliseconds;
  }

  /**
   * Where the vertices are now on their way, slowly at first and at the end.
   * @param {Float64Array} to `#V by 3`, which may be on its way itself
   */
  towards(to) {
    if (to === this.#first) return this.#from;
    const now = performance.now();
    this.#began ||= now;
    this.part = Math.min(1, (now - this.#began) / this.#milliseconds);
    const part = this.part * this.part * (3 - 2 * this.part);
    for (let i = 0; i < to.length; i++)
      this.#mixed[i] = this.#from[i] + part * (to[i] - this.#from[i]);
    return this.#mixed;
  }
}
