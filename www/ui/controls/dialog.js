/** Dialogs: a title, the cross that closes them, and what they are about. */

import '../styles/dialog.css';
import { element } from '../dom.js';
import { closeButton } from './fields.js';

/**
 * The title of a dialog, and the cross that closes it.
 * @param {HTMLDialogElement} dialog
 * @param {string} id of the title, which the dialog is labelled by
 * @param {string} title
 */
export function dialogHead(dialog, id, title) {
  return element(
    'div.dialog-head',
    element('h2', { id }, title),
    closeButton('Close', () => dialog.close(), { class: 'square' }),
  );
}

/**
 * Shows a dialog, which is gone when it is closed.
 * @param {{ id: string, title: string, light?: boolean }} about `light`: a press beside it closes it
 * @param {...Node} body
 */
export function openDialog({ id, title, light = false }, ...body) {
  const dialog = element('dialog', { id, 'aria-labelledby': `${id}-title` });
  dialog.append(dialogHead(dialog, `${id}-title`, title), ...body);
  dialog.addEventListener('close', () => dialog.remove());
  if (light)
    dialog.addEventListener('click', (event) => {
      if (event.target === dialog) dialog.close();
    });
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
