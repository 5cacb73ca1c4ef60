/**
 * Keeps the keyboard focus when what had it is removed, hidden or disabled: browsers then give it to
 * the body, without an event, and the next press of Tab begins at the top of the page.
 */

/** How often it is looked for, in milliseconds. */
const EVERY_MS = 200;

/** @param place what gets the focus, unless a dialog is open */
export function keepFocus(place: HTMLElement) {
  /** What had the focus last. */
  let last: EventTarget | null = null;
  document.addEventListener('focusin', ({ target }) => (last = target));
  setInterval(() => {
    // A press beside all controls takes the focus away on purpose.
    if (document.activeElement !== document.body || !(last instanceof HTMLElement)) return;
    if (last.checkVisibility({ visibilityProperty: true }) && !last.matches(':disabled')) return;
    const dialogs = document.querySelectorAll<HTMLElement>('dialog:modal');
    const next = [...dialogs].at(-1) ?? place;
    next.focus({ preventScroll: true });
  }, EVERY_MS);
}
