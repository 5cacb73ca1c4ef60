/** The place under the view, where one panel is open at a time. */

import './docked.css';
import { byId, leave } from '../ui/dom.js';

/** Closes the panel that is open. @type {(() => void) | null} */
let closeOpen = null;

/** @param {HTMLElement} panel of class `docked`, hidden so far @param {() => void} close */
export function dock(panel, close) {
  closeOpen?.();
  closeOpen = close;
  if (!panel.isConnected) byId('main').after(panel);
  panel.hidden = false;
  document.body.dataset.docked = panel.id;
}

/** @param {HTMLElement} panel that is open */
export function undock(panel) {
  closeOpen = null;
  leave(panel, () => (panel.hidden = true));
  delete document.body.dataset.docked;
}
