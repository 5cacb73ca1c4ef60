/** Dialogs with a title, a close button, and a body. */

import '../styles/dialog.css';
import { element } from '../dom.js';
import { closeButton } from './fields.js';

/**
 * Makes the head of a dialog: its title and close button.
 * @param {HTMLDialogElement} dialog
 * @param {string} id of the title, which labels the dialog
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
 * Shows a dialog, and removes it when it is closed.
 * @param {{ id: string, title: string, light?: boolean }} about `light`: a click outside closes it
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
