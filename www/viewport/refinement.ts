/**
 * Decides when the view draws ambient occlusion: with every picture if that is fast enough,
 * otherwise once nothing moves. It takes three more passes, which are slow only in software.
 */

import type { View } from '../pkg/view-webgl2/shape_up.js';

/** Above this time, in milliseconds, a picture in motion is too slow for occlusion. */
const TOO_SLOW = 50;
/** Up to this time, a picture without occlusion is fast enough to add it. */
const FAST = 25;
/** Number of consecutive fast pictures that switch it on, and of slow ones that switch it off. */
const [FAST_ONES, SLOW_ONES] = [12, 3];
/** Milliseconds without motion after which it fades in. */
const STILL = 220;
/** Strength of occlusion in the successive pictures of the fade-in. */
const STEPS = [0.4, 0.75, 1];

/** Decides from the times of pictures in motion, with hysteresis. */
export class Budget {
  /** Whether pictures in motion show occlusion. */
  isLive = false;
  #fast = 0;
  #slow = 0;
  /** Fast pictures needed; more after every time that it was too slow. */
  #needed = FAST_ONES;

  /** @param milliseconds that a picture in motion took */
  took(milliseconds: number) {
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
  #waiting: ReturnType<typeof setTimeout> | undefined;
  /** Fade-in step of the next picture; null while something moves. */
  #step: number | null = null;
  /** Whether the fade-in has just been requested. */
  #begins = false;
  /** Whether the next picture shows motion. */
  #isMoved = false;
  #requestPicture;

  constructor(requestPicture: () => void) {
    this.#requestPicture = requestPicture;
  }

  /** Sets the strength of occlusion before a picture. */
  prepare(view: View) {
    const fits = view.occlusionFits();
    if (!fits && !this.#begins) this.#step = null;
    this.#isMoved = this.#step === null && !fits && view.needsDraw();
    if (this.#step !== null) {
      view.setOcclusion(STEPS[this.#step]);
      // This strength is already shown.
      if (!view.needsDraw()) this.#step = null;
    }
    // If only other things changed, the occlusion stays.
    else if (this.#isMoved) view.setOcclusion(this.#budget.isLive ? 1 : 0);
  }

  /** Updates the state after a picture. */
  drawn() {
    this.#begins = false;
    if (this.#step !== null) {
      this.#step = this.#step + 1 < STEPS.length ? this.#step + 1 : null;
      if (this.#step !== null) this.#requestPicture();
    } else if (this.#isMoved) {
      const began = performance.now();
      requestAnimationFrame(() => this.#budget.took(performance.now() - began));
      clearTimeout(this.#waiting);
      if (!this.#budget.isLive) this.#waiting = setTimeout(() => this.#begin(0), STILL);
    }
  }

  /** Shows full occlusion with the next picture. */
  finish() {
    clearTimeout(this.#waiting);
    this.#begin(STEPS.length - 1);
  }

  #begin(step: number) {
    this.#step = step;
    this.#begins = true;
    this.#requestPicture();
  }
}
