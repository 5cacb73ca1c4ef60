/** Animated transition from one shape to another, so that the effect of a command is visible. */

import type { Geometry } from '../solver/solver-client.ts';

type Shape = Pick<Geometry, 'positions' | 'generation'>;

export class ShapeTransition {
  #from;
  #milliseconds;
  #mixed;
  /** Generation of the shape at creation: the transition starts when another one arrives. */
  #first;
  #began = 0;
  /** Progress from 0 to 1. */
  part = 0;

  /** @param from its positions may be overwritten afterwards */
  constructor({ positions, generation }: Shape, milliseconds: number) {
    this.#first = generation;
    this.#from = positions.slice();
    this.#mixed = positions.slice();
    this.#milliseconds = milliseconds;
  }

  /**
   * Returns the current positions, eased in and out.
   * @param shape which may change during the transition
   */
  towards({ positions: to, generation }: Shape) {
    if (generation === this.#first) return this.#from;
    const now = performance.now();
    this.#began ||= now;
    this.part = Math.min(1, (now - this.#began) / this.#milliseconds);
    const part = this.part * this.part * (3 - 2 * this.part);
    for (let i = 0; i < to.length; i++)
      this.#mixed[i] = this.#from[i] + part * (to[i] - this.#from[i]);
    return this.#mixed;
  }
}
