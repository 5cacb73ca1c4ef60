/** The menu Open recent: works saved in this browser. */

import { useLayoutEffect, useState } from 'preact/hooks';
import { useApp } from '../store/use-app.ts';
import { byId } from '../ui/dom.ts';
import type { Work } from './recent-documents.ts';

/** The popover that the menu is in. */
const popover = () => byId('recent');
const isOpen = () => popover().matches(':popover-open');

export function RecentMenu() {
  const app = useApp();
  /** As they were when the menu was opened last. */
  const [list, setList] = useState<Work[] | null>(null);
  useLayoutEffect(() => {
    // The button closes the open menu by itself.
    const open = async (event: Event) => {
      if (isOpen()) return;
      event.preventDefault();
      setList(await app.works.recent().catch(() => []));
    };
    const button = byId('recent-button');
    button.addEventListener('click', open);
    return () => button.removeEventListener('click', open);
  }, []);
  useLayoutEffect(() => {
    if (list && !isOpen()) popover().showPopover();
  }, [list]);
  // A menu needs an entry for screen readers to announce its text.
  if (list?.length === 0) {
    return (
      <p class="quiet" role="menuitem" aria-disabled="true" tabindex={-1}>
        Nothing else yet. Files that you open and examples that you change are saved in this browser
        and listed here.
      </p>
    );
  }
  return (
    <>
      {list?.map((work) => (
        <button
          key={work.id}
          type="button"
          role="menuitem"
          onClick={() => {
            popover().hidePopover();
            void app.works.openWork(work);
          }}
        >
          <span class="entry">
            <strong>{work.title}</strong>
            <span>
              {dateOf(work.savedAt)}, iteration {work.iteration}
            </span>
          </span>
        </button>
      ))}
    </>
  );
}

/** In the language of the page. */
function dateOf(time: number) {
  return new Date(time).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' });
}
