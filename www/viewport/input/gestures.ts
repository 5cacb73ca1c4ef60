/** What keys, wheel and fingers do to a picture, and how accurate a pointer is. */

import { ARROWS } from '../../ui/keys.ts';
import type { Viewport } from '../viewport.ts';

/** An arrow key orbits like a drag of so many CSS pixels; a page key zooms by this factor. */
const ORBIT_STEP = 24;
const ZOOM_STEP = 1.25;

const ZOOMS: Record<string, number> = { PageUp: ZOOM_STEP, PageDown: 1 / ZOOM_STEP };

/**
 * @param place of the picture
 * @param on.move in the direction of an arrow
 * @param on.zoom about the centre of the place
 */
export function bindMoveKeys(
  place: HTMLElement,
  {
    move,
    zoom,
  }: { move: (x: number, y: number) => void; zoom: (factor: number, x: number, y: number) => void },
) {
  place.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    const factor = ZOOMS[event.key];
    if (!arrow && !factor) return;
    event.preventDefault();
    if (arrow) move(...arrow);
    else zoom(factor, place.clientWidth / 2, place.clientHeight / 2);
  });
}

export function bindViewKeys(viewport: Viewport) {
  bindMoveKeys(viewport.element, {
    move: (x, y) => viewport.with((view) => view.orbit(ORBIT_STEP * x, ORBIT_STEP * y)),
    zoom: (...about) => viewport.with((view) => view.zoom(...about)),
  });
}

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

/** Distance within which a pointer hits a dot. */
const NEAR = { mouse: 12, pen: 14, touch: 24 };
/** A press that moves less than this is a click. */
const CLICK_SLOP = { mouse: 4, pen: 6, touch: 10 };

export const near = (event: MouseEvent) => NEAR[typeOf(event)] ?? NEAR.mouse;

export const clickTolerance = (event: MouseEvent) => CLICK_SLOP[typeOf(event)] ?? CLICK_SLOP.mouse;

function typeOf(event: MouseEvent) {
  const type = event instanceof PointerEvent ? event.pointerType : 'mouse';
  return type as keyof typeof NEAR;
}
