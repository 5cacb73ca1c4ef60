/**
 * When the view shows that what is near keeps light off: with every picture where that is fast enough, and
 * otherwise once nothing moves. It takes three passes more, which a graphics card does by the way and
 * software does not.
 */

/** A picture in motion that takes longer than this has to do without, in milliseconds. */
const TOO_SLOW = 50;
/** One that takes no longer without can afford it. */
const FAST = 25;
/** So many in a row decide for it, and against it. */
const [FAST_ONES, SLOW_ONES] = [12, 3];
/** Nothing has moved for so long. */
const STILL = 220;
/** How much of it is seen, from picture to picture, once nothing moves. */
const STEPS = [0.4, 0.75, 1];

/** Decides from the times of pictures in motion, and does not change its mind at every one. */
export class Budget {
  /** Whether pictures in motion show it. */
  isLive = false;
  #fast = 0;
  #slow = 0;
  /** Longer after every time that it was too slow. */
  #needed = FAST_ONES;

  /** @param {number} milliseconds that a picture in motion took */
  took(milliseconds) {
    this.#fast = milliseconds <= FAST ? this.#fast + 1 : 0;
    this.#slow = milliseconds > TOO_SLOW ? this.#slow + 1 : 0;
    if (this.isLive && this.#slow >= SLOW_ONES) {
      this.isLive = false;
      this.#needed *= 4;
    } else if (!this.isLive && this.#fast >= this.#needed) {
      this.isLive = true;
    }
  }
}

export class Refinement {
  #budget = new Budget();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #waiting;
  /** The step that the next picture shows; none while something moves. @type {number | null} */
  #step = null;
  /** It is the first one. */
  #begins = false;
  /** The next picture shows something in another place. */
  #isMoved = false;
  #ask;

  /** @param {() => void} ask for a picture */
  constructor(ask) {
    this.#ask = ask;
  }

  /**
   * Before a picture: how much of it is to be seen.
   * @param {import("../pkg/view-webgl2/shape_up.js").View} view
   */
  prepare(view) {
    const fits = view.occlusionFits();
    if (!fits && !this.#begins) this.#step = null;
    this.#isMoved = this.#step === null && !fits && view.needsDraw();
    if (this.#step !== null) {
      view.setOcclusion(STEPS[this.#step]);
      // It is there already.
      if (!view.needsDraw()) this.#step = null;
    }
    // What is still as it was keeps its look, whatever else is new.
    else if (this.#isMoved) view.setOcclusion(this.#budget.isLive ? 1 : 0);
  }

  /** After it. */
  drawn() {
    this.#begins = false;
    if (this.#step !== null) {
      this.#step = this.#step + 1 < STEPS.length ? this.#step + 1 : null;
      if (this.#step !== null) this.#ask();
    } else if (this.#isMoved) {
      const began = performance.now();
      requestAnimationFrame(() => this.#budget.took(performance.now() - began));
      clearTimeout(this.#waiting);
      if (!this.#budget.isLive) this.#waiting = setTimeout(() => this.#begin(0), STILL);
    }
  }

  /** Shows all of it with the next picture. */
  finish() {
    clearTimeout(this.#waiting);
    this.#begin(STEPS.length - 1);
  }

  /** @param {number} step */
  #begin(step) {
    this.#step = step;
    this.#begins = true;
    this.#ask();
  }
}
