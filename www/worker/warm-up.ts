/**
 * Warms up the solver's functions before the user needs them, and measures the speed of the
 * computer: see `src/web/warm_up.rs`. Runs in slices, when the worker is idle.
 */

import { WarmUp } from '../pkg/engine/shape_up.js';

/** Idle time before it begins, in milliseconds. */
const QUIET_MS = 400;

let begun = false;
let most: number | undefined;
let quietSince = 0;

/** Resets the idle time. */
export function resetIdle() {
  quietSince = performance.now();
}

/**
 * Begins once, after the first picture is shown. Iterating warms up, too, so that stops it.
 * @param isBusy whether the solver iterates
 */
export function warmUpWhenQuiet(isBusy: () => boolean) {
  if (begun) return;
  begun = true;
  const work = new WarmUp();
  const advance = () => {
    const quiet = performance.now() - quietSince;
    if (isBusy()) work.free();
    else if (quiet < QUIET_MS) setTimeout(advance, QUIET_MS - quiet);
    else if (work.advance()) setTimeout(advance);
    else finish(work);
  };
  advance();
}

/** Returns the number of faces up to which this computer stays interactive, measured if unknown. */
export function mostFaces() {
  if (most === undefined) {
    const work = new WarmUp();
    while (work.advance());
    finish(work);
  }
  if (most === undefined) throw new Error('the speed of this computer could not be measured');
  return most;
}

/** @param work completed */
function finish(work: WarmUp) {
  most = work.mostFaces();
  work.free();
}
