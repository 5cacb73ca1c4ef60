/** Accuracy of mouse, pen and finger, in CSS pixels. */

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
