/** A handle on a track: moved by dragging or keys, reset by a double click. */

/** The step of the page keys, and of an arrow with Shift. */
const LARGE = 0.1;
const ARROWS: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
const JUMPS: Record<string, number> = { PageUp: LARGE, PageDown: -LARGE, Home: -1, End: 1 };
const RESET = ['Delete', 'Backspace'];

/**
 * @param handle with `role="slider"`
 * @param about.track the track; its width is the range
 * @param about.at the position, from 0 to 1; null if there is none
 * @param about.moveTo from 0 to 1
 * @param about.step of an arrow key
 */
export function followTrack(
  handle: HTMLElement,
  {
    track,
    at,
    moveTo,
    reset,
    step,
  }: {
    track: () => Element | null;
    at: () => number | null;
    moveTo: (at: number) => void;
    reset: () => void;
    step: number;
  },
) {
  /** Offset from the pointer to the centre of the handle during a drag, in pixels. */
  let grabbed: number | null = null;
  const move = (to: number) => moveTo(Math.min(Math.max(to, 0), 1));
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
