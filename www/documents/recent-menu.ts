/** The menu Open recent: works saved in this browser. */

import { element } from '../ui/dom.ts';
import type { Work } from './recent-documents.ts';

/** Refills the menu, then shows it. */
export async function showRecent(
  menu: HTMLElement,
  startup: {
    saveNow: () => Promise<void>;
    recent: () => Promise<Work[]>;
    openWork: (work: Work) => void;
  },
) {
  await startup.saveNow().catch(() => {});
  const list = await startup.recent().catch(() => []);
  const open = (work: Work) => {
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

function dateOf(time: number) {
  return new Date(time).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' });
}
