/** Animated transition from one shape to another, so that the effect of a command is visible. */

export class ShapeTransition {
  #from;
  #milliseconds;
  #mixed;
  /** The positions at creation: the transition starts when newer ones arrive. */
  #first;
  #began = 0;
  /** Progress from 0 to 1. */
  part = 0;

  /** @param from `#V by 3`; it may be overwritten afterwards */
  constructor(from: Float64Array, milliseconds: number) {
    this.#first = from;
    this.#from = from.slice();
    this.#mixed = from.slice();
    this.#milliseconds = milliseconds;
  }

  /**
   * Returns the current positions, eased in and out.
   * @param to `#V by 3`, which may change during the transition
   */
  towards(to: Float64Array) {
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
