/**
 * Keeps the keyboard focus when what had it is removed, hidden or disabled: browsers then give it to
 * the body, without an event, and the next press of Tab begins at the top of the page.
 */

/** After what else a press changes, which may take the focus itself, in milliseconds. */
const LATER_MS = 60;

/** @param place what gets the focus, unless a dialog is open */
export function keepFocus(place: HTMLElement) {
  /** What had the focus last. */
  let last: EventTarget | null = null;
  document.addEventListener('focusin', ({ target }) => (last = target));
  let timer = 0;
  function look() {
    timer = 0;
    const { activeElement } = document;
    // A press beside all controls takes the focus away on purpose.
    if (activeElement !== document.body && activeElement !== last) return;
    if (!(last instanceof HTMLElement) || last === document.body) return;
    if (last.checkVisibility({ visibilityProperty: true }) && !last.matches(':disabled')) return;
    const dialogs = document.querySelectorAll<HTMLElement>('dialog:modal');
    const next = [...dialogs].at(-1) ?? place;
    next.focus({ preventScroll: true });
  }
  const changes = new MutationObserver(() => (timer ||= window.setTimeout(look, LATER_MS)));
  // Those that can hide or disable what has the focus.
  const attributeFilter = [
    'hidden',
    'disabled',
    'open',
    'inert',
    'class',
    'data-step',
    'data-sheet',
  ];
  changes.observe(document.body, { attributeFilter, childList: true, subtree: true });
}
