/** The cameras that the user has looked through: back to the last one, and forward again. */

import { fly } from '../../viewport/camera.ts';
import { DISTANCE, FRAMED, TILT, TURN } from '../../viewport/flight.ts';
import type { AppContext } from '../../app/context.ts';

/** How long the camera rests before it counts as one to go back to, in milliseconds. */
const REST_MS = 400;
/** The number of cameras kept. */
const MOST = 50;

export class ViewHistory {
  #app;
  #seen: number[][] = [];
  /** The place of the current camera in them. */
  #at = -1;
  #timer = 0;

  constructor(app: AppContext) {
    this.#app = app;
    app.store.subscribe(['camera'], ({ camera }) => {
      clearTimeout(this.#timer);
      if (camera) this.#timer = window.setTimeout(() => this.#rest(camera), REST_MS);
    });
    app.solver.on('model', () => {
      this.#seen = [];
      this.#at = -1;
    });
  }

  /** Keeps a camera that has come to rest; those that were gone back from are forgotten. */
  #rest(camera: number[]) {
    const last = this.#seen[this.#at];
    if (last && isSame(camera, last)) return;
    // The page frames the model anew when something covers the view: nobody looked there.
    if (last && isFramed(last) && isFramed(camera) && isAlongside(camera, last)) {
      this.#seen[this.#at] = camera;
      return;
    }
    this.#seen = [...this.#seen.slice(0, this.#at + 1), camera].slice(-MOST);
    this.#at = this.#seen.length - 1;
  }

  /** Goes back (-1) or forward (1). */
  go(step: -1 | 1) {
    const { actions, viewport } = this.#app;
    const camera = this.#seen[this.#at + step];
    if (!camera) return actions.setStatus(`No view to go ${step < 0 ? 'back' : 'on'} to`);
    this.#at += step;
    fly(viewport, (view) => view.placeCamera(Float64Array.from(camera)));
    actions.setStatus(step < 0 ? 'The view before' : 'The view after');
  }
}

/** Largest difference of cameras that look the same: of angles, and of lengths over the distance. */
const ROUNDING = 1e-5;

/** Whether two cameras look the same, up to the rounding of a flight. */
function isSame(a: number[], b: number[]) {
  const most = (at: number) => ROUNDING * (at <= DISTANCE ? a[DISTANCE] : 1);
  return a.every((value, at) => Math.abs(value - b[at]) < most(at));
}

/** Whether the page chose the camera. */
const isFramed = (camera: number[]) => camera[FRAMED] === 1;

/** Whether two cameras look in the same direction. */
const isAlongside = (a: number[], b: number[]) =>
  [TURN, TILT].every((at) => Math.abs(a[at] - b[at]) < ROUNDING);
