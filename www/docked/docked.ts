/** The area below the view, which shows one docked panel at a time. */

import './docked.css';
import { byId, removeKeepingFocus } from '../ui/dom.ts';

/** Closes the open panel. */
let closeOpen: (() => void) | null = null;

/**
 * Docks a panel. Returns functions that toggle and close it; Escape closes it, too.
 * @param panel of class `docked`, initially hidden
 */
export function docked(
  panel: HTMLElement,
  { opened, closed }: { opened: () => void; closed: () => void },
): { toggle: () => void; close: () => void } {
  function close() {
    closeOpen = null;
    removeKeepingFocus(panel, () => (panel.hidden = true));
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
