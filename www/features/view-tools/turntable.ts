/** Turns the model slowly, as on a turntable, until the user touches the view. */

import type { Viewport } from '../../viewport/viewport.ts';

/** Seconds per turn. */
const TURN = 24;
const EVENTS = ['pointerdown', 'wheel', 'keydown'] as const;

/** Stops the current turning. */
let end: (() => void) | null = null;

/** Starts turning, or stops it. */
export function turnSlowly(viewport: Viewport) {
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

  function turn(now: number) {
    // A page that was hidden continues from the same angle.
    const passed = Math.min(Math.max(now - last, 0), 100);
    last = now;
    viewport.unmeasured((view) => view.spin((2 * Math.PI * passed) / 1000 / TURN));
    request = requestAnimationFrame(turn);
  }
}
