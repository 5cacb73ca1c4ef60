/** The menu Open recent: works saved in this browser. */

import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../store/use-app.ts';
import { Entry, Menu } from '../ui/components/menu.tsx';
import { byId } from '../ui/dom.ts';
import type { Work } from './recent-documents.ts';

const opener = () => byId('recent-button');

export function RecentMenu() {
  const app = useApp();
  const menu = useRef<HTMLDivElement>(null);
  const isOpen = () => menu.current?.matches(':popover-open') ?? false;
  /** As they were when the menu was opened last. */
  const [list, setList] = useState<Work[] | null>(null);
  useLayoutEffect(() => {
    // The button closes the open menu by itself.
    const open = async (event: Event) => {
      if (isOpen()) return;
      event.preventDefault();
      setList(await app.works.recent().catch(() => []));
    };
    opener().addEventListener('click', open);
    return () => opener().removeEventListener('click', open);
  }, []);
  useLayoutEffect(() => {
    if (list && !isOpen()) menu.current?.showPopover();
  }, [list]);
  return (
    <Menu of={menu} anchor={opener} id="recent" role="menu" aria-label="Open recent">
      {/* A menu needs an entry for screen readers to announce its text. */}
      {list?.length === 0 && (
        <p class="quiet" role="menuitem" aria-disabled="true" tabindex={-1}>
          Nothing else yet. Files that you open and examples that you change are saved in this
          browser and listed here.
        </p>
      )}
      {list?.map((work) => (
        <button
          key={work.id}
          type="button"
          role="menuitem"
          onClick={() => {
            menu.current?.hidePopover();
            void app.works.openWork(work);
          }}
        >
          <Entry title={work.title}>
            {dateOf(work.savedAt)}, iteration {work.iteration}
          </Entry>
        </button>
      ))}
    </Menu>
  );
}

/** In the language of the page. */
function dateOf(time: number) {
  return new Date(time).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' });
}
