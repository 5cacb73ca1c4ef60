/** The place under the view, where one panel is open at a time. */

import './docked.css';
import { byId, leave } from '../ui/dom.js';

/** Closes the panel that is open. @type {(() => void) | null} */
let closeOpen = null;

/**
 * Makes a panel one of this place: it opens and closes by turns, and Escape closes it.
 * @param {HTMLElement} panel of class `docked`, hidden so far
 * @param {{ opened: () => void, closed: () => void }} on
 * @returns {{ toggle: () => void, close: () => void }}
 */
export function docked(panel, { opened, closed }) {
  function close() {
    closeOpen = null;
    leave(panel, () => (panel.hidden = true));
    delete document.body.dataset.docked;
    closed();
  }

  panel.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
  });
  return {
    close,
    toggle() {
      if (!panel.hidden) return close();
      closeOpen?.();
      closeOpen = close;
      if (!panel.isConnected) byId('main').after(panel);
      panel.hidden = false;
      document.body.dataset.docked = panel.id;
      opened();
    },
  };
}
