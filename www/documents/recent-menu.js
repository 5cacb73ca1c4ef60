/** The menu Open recent: works saved in this browser. */

import { element } from '../ui/dom.js';

/** @typedef {import("./recent-documents.js").Work} Work */

/**
 * Refills the menu, then shows it.
 * @param {HTMLElement} menu
 * @param {{ saveNow: () => Promise<void>, recent: () => Promise<Work[]>, openWork: (work: Work) => void }} startup
 */
export async function showRecent(menu, startup) {
  await startup.saveNow().catch(() => {});
  const list = await startup.recent().catch(() => []);
  const open = (/** @type {Work} */ work) => {
    menu.hidePopover();
    startup.openWork(work);
  };
  const rows = list.map((work) =>
    element(
      'button',
      { role: 'menuitem', onclick: () => open(work) },
      element(
        'span.entry',
        element('strong', work.title),
        element('span', `${dateOf(work.savedAt)}, iteration ${work.iteration}`),
      ),
    ),
  );
  menu.replaceChildren(...(rows.length > 0 ? rows : [noEntry()]));
  menu.showPopover();
}

/** A menu needs an entry for screen readers to announce its text. */
function noEntry() {
  return element(
    'p.quiet',
    { role: 'menuitem', 'aria-disabled': 'true', tabindex: '-1' },
    'Nothing else yet. What you open or change is saved in this browser and listed here.',
  );
}

/** @param {number} time */
function dateOf(time) {
  return new Date(time).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' });
}
