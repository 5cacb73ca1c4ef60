/** Accuracy of mouse, pen and finger, in CSS pixels. */

/** Distance within which a pointer hits a dot. */
const NEAR = { mouse: 12, pen: 14, touch: 24 };
/** A press that moves less than this is a click. */
const CLICK_SLOP = { mouse: 4, pen: 6, touch: 10 };

/** @param {MouseEvent} event */
export const near = (event) => NEAR[typeOf(event)] ?? NEAR.mouse;

/** @param {MouseEvent} event */
export const clickTolerance = (event) => CLICK_SLOP[typeOf(event)] ?? CLICK_SLOP.mouse;

/** @param {MouseEvent} event */
function typeOf(event) {
  const type = event instanceof PointerEvent ? event.pointerType : 'mouse';
  return /** @type {keyof typeof NEAR} */ (type);
}
