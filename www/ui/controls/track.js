/** A handle on a track: moved by dragging or keys, reset by a double click. */

/** The step of the page keys, and of an arrow with Shift. */
const LARGE = 0.1;
/** @type {Record<string, number>} */
const ARROWS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
/** @type {Record<string, number>} */
const JUMPS = { PageUp: LARGE, PageDown: -LARGE, Home: -1, End: 1 };
const RESET = ['Delete', 'Backspace'];

/**
 * @param {HTMLElement} handle with `role="slider"`
 * @param {object} about
 * @param {() => Element | null} about.track the track; its width is the range
 * @param {() => number | null} about.at the position, from 0 to 1; null if there is none
 * @param {(at: number) => void} about.moveTo from 0 to 1
 * @param {() => void} about.reset
 * @param {number} about.step of an arrow key
 */
export function followTrack(handle, { track, at, moveTo, reset, step }) {
  /**
   * Offset from the pointer to the centre of the handle during a drag, in pixels.
   * @type {number | null}
   */
  let grabbed = null;
  const move = (/** @type {number} */ to) => moveTo(Math.min(Math.max(to, 0), 1));
  handle.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const { left, width } = handle.getBoundingClientRect();
    grabbed = left + width / 2 - event.clientX;
    handle.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    event.preventDefault();
  });
  handle.addEventListener('pointermove', (event) => {
    const box = track()?.getBoundingClientRect();
    if (grabbed !== null && box) move((event.clientX + grabbed - box.left) / box.width);
  });
  handle.addEventListener('lostpointercapture', () => (grabbed = null));
  handle.addEventListener('dblclick', reset);
  handle.addEventListener('keydown', (event) => {
    const from = at();
    if (from === null || event.ctrlKey || event.metaKey || event.altKey) return;
    const by = JUMPS[event.key] ?? ARROWS[event.key] * (event.shiftKey ? LARGE : step);
    if (by) move(from + by);
    else if (RESET.includes(event.key)) reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
}

/**
 * Sets the position of a handle and its accessible value, in per cent and in words.
 * @param {HTMLElement} handle
 * @param {number} at from 0 to 1
 * @param {string} words
 */
export function placeOnTrack(handle, at, words) {
  handle.style.left = `${100 * at}%`;
  handle.ariaValueMin = '0';
  handle.ariaValueMax = '100';
  handle.ariaValueNow = String(Math.round(100 * at));
  handle.ariaValueText = words;
}
