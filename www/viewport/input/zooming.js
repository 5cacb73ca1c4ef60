/** How much a turn of the wheel enlarges, and a pinch of two fingers. */

/** Wheel delta, in pixels, that zooms by e; and of a pinch, which comes as a wheel with Ctrl. */
const WHEEL_PIXELS = 700;
const PINCH_PIXELS = 100;
const LINE_PIXELS = 16;
/** One event is at most so much of that. */
const MOST = 0.5;

/**
 * The factor of a wheel event.
 * @param {WheelEvent} event
 * @param {number} page height of what is scrolled, in pixels
 */
export function wheelFactor({ deltaMode, deltaY, ctrlKey }, page) {
  const unit = [1, LINE_PIXELS, page][deltaMode] ?? 1;
  const exponent = (-deltaY * unit) / (ctrlKey ? PINCH_PIXELS : WHEEL_PIXELS);
  return Math.exp(Math.max(-MOST, Math.min(MOST, exponent)));
}

/**
 * The middle of two fingers, and how far they are apart.
 * @param {[number, number]} a
 * @param {[number, number]} b
 */
export function pair(a, b) {
  return {
    x: (a[0] + b[0]) / 2,
    y: (a[1] + b[1]) / 2,
    apart: Math.hypot(a[0] - b[0], a[1] - b[1]),
  };
}
