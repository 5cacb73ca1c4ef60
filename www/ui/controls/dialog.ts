/** Dialogs that are open. */

/** Dialogs about the open model. */
const ABOUT_MODEL = 'dialog[data-about="model"]';

/**
 * Closes the dialogs about a model that another one has replaced.
 * @returns whether there were any
 */
export function closeAboutModel() {
  const dialogs = document.querySelectorAll<HTMLDialogElement>(ABOUT_MODEL);
  for (const dialog of dialogs) dialog.close();
  return dialogs.length > 0;
}

/**
 * Moves an element into the dialog in front, as long as that is open: outside of it nothing can be
 * pressed.
 * @param home where it is, as the first, without a dialog
 */
export function showInFront(place: HTMLElement, home: HTMLElement) {
  const front = [...document.querySelectorAll<HTMLElement>('dialog:modal')].at(-1);
  const parent = front ?? home;
  if (place.parentElement === parent) return;
  parent.prepend(place);
  front?.addEventListener('close', () => showInFront(place, home), { once: true });
}
