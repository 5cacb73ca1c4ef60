/**
 * Lets the solver's functions run for a while before somebody waits for them, and tells from it what
 * the machine can do: see `src/web/warm_up.rs`. In slices, when the worker has nothing else to do.
 */

import { WarmUp } from '../pkg/solver/shape_up.js';

/** Begins when nothing has been asked for so long. */
const QUIET_MS = 400;

let begun = false;
/** @type {number | undefined} */
let most;
let quietSince = 0;

/** Something was asked. */
export function disturb() {
  quietSince = performance.now();
}

/**
 * Begins once, after the first picture is on the screen. What runs by itself warms up by itself.
 * @param {() => boolean} isBusy whether the solver iterates
 */
export function warmUpWhenQuiet(isBusy) {
  if (begun) return;
  begun = true;
  const work = new WarmUp();
  const goOn = () => {
    const quiet = performance.now() - quietSince;
    if (isBusy()) work.free();
    else if (quiet < QUIET_MS) setTimeout(goOn, QUIET_MS - quiet);
    else if (work.goOn()) setTimeout(goOn);
    else finish(work);
  };
  goOn();
}

/** The most faces of a mesh that this machine works with at once; measured now where it is not known. */
export function mostFaces() {
  if (most === undefined) {
    const work = new WarmUp();
    while (work.goOn());
    finish(work);
  }
  if (most === undefined) throw new Error('how fast this machine is could not be measured');
  return most;
}

/** @param {WarmUp} work all of it done */
function finish(work) {
  most = work.mostFaces();
  work.free();
}
