/** Dialogs with a title, a close button, and a body. */

import '../styles/dialog.css';
import { element } from '../dom.ts';
import { closeButton } from './fields.ts';

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

/**
 * Shows a dialog, and removes it when it is closed. The one that a quick second press asks for takes
 * the place of the first.
 * @param about `light`: a click outside closes it; `lasts`: it is not about the open model
 */
export function openDialog(
  {
    id,
    title,
    light = false,
    lasts = false,
  }: { id: string; title: string; light?: boolean; lasts?: boolean },
  ...body: Node[]
) {
  const before = document.getElementById(id);
  if (before instanceof HTMLDialogElement) before.close();
  const dialog = element('dialog', {
    id,
    'aria-labelledby': `${id}-title`,
    ...(!lasts && { 'data-about': 'model' }),
  });
  const head = element(
    'div.dialog-head',
    element('h2', { id: `${id}-title` }, title),
    closeButton('Close', () => dialog.close(), { class: 'square' }),
  );
  dialog.append(head, ...body);
  dialog.addEventListener('close', () => dialog.remove());
  if (light) {
    // A drag that selects text may end outside.
    let isBegunOutside = false;
    dialog.addEventListener('pointerdown', ({ target }) => (isBegunOutside = target === dialog));
    dialog.addEventListener('click', ({ target }) => {
      if (target === dialog && isBegunOutside) dialog.close();
    });
  }
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
