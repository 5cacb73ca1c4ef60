/** Zoom factors of the wheel and of a pinch. */

/** Wheel delta in pixels that zooms by e; the same for a pinch, reported as a wheel with Ctrl. */
const WHEEL_PIXELS = 700;
const PINCH_PIXELS = 100;
const LINE_PIXELS = 16;
/** Largest exponent of a single event. */
const MOST = 0.5;

/**
 * Returns the zoom factor of a wheel event.
 * @param page height of the scrolled element, in pixels
 */
export function wheelFactor({ deltaMode, deltaY, ctrlKey }: WheelEvent, page: number) {
  const unit = [1, LINE_PIXELS, page][deltaMode] ?? 1;
  const exponent = (-deltaY * unit) / (ctrlKey ? PINCH_PIXELS : WHEEL_PIXELS);
  return Math.exp(Math.max(-MOST, Math.min(MOST, exponent)));
}

/** Returns the midpoint and the distance of two fingers. */
export function pair(a: [number, number], b: [number, number]) {
  return {
    x: (a[0] + b[0]) / 2,
    y: (a[1] + b[1]) / 2,
    apart: Math.hypot(a[0] - b[0], a[1] - b[1]),
  };
}
