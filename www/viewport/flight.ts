/** Short camera animations. */

import type { Viewport } from './viewport.ts';
import type { View } from './layers.ts';

const FLIGHT_MS = 320;
const still = matchMedia('(prefers-reduced-motion: reduce)');

/** Moves the camera as `change` does: animated, or at once if the user prefers reduced motion. */
export function fly(viewport: Viewport, change: (view: View) => void) {
  if (still.matches) return void viewport.with(change);
  viewport.with((view) => {
    view.planFlight();
    change(view);
    view.takeOff();
  });
  const started = performance.now();
  const on = () => {
    const part = Math.min(1, (performance.now() - started) / FLIGHT_MS);
    if (viewport.unmeasured((view) => view.fly(part))) requestAnimationFrame(on);
  };
  requestAnimationFrame(on);
}
