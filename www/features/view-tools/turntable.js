/** Turns the model slowly, as on a turntable, until the user touches the view. */

/** Seconds per turn. */
const TURN = 24;
const EVENTS = /** @type {const} */ (['pointerdown', 'wheel', 'keydown']);

/** Stops the current turning. @type {(() => void) | null} */
let end = null;

/**
 * Starts turning, or stops it.
 * @param {import("../../viewport/viewport.js").Viewport} viewport
 */
export function turnSlowly(viewport) {
  if (end) return end();
  let last = performance.now();
  let request = requestAnimationFrame(turn);
  const listening = new AbortController();
  end = () => {
    cancelAnimationFrame(request);
    listening.abort();
    end = null;
  };
  for (const event of EVENTS)
    viewport.element.addEventListener(event, end, {
      capture: true,
      passive: true,
      signal: listening.signal,
    });

  function turn(/** @type {number} */ now) {
    // A page that was hidden continues from the same angle.
    const passed = Math.min(Math.max(now - last, 0), 100);
    last = now;
    viewport.unmeasured((view) => view.spin((2 * Math.PI * passed) / 1000 / TURN));
    request = requestAnimationFrame(turn);
  }
}
