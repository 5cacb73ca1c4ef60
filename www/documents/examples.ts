/** The examples: their menu with pictures, their links, and their statements. */

import { element } from '../ui/dom.ts';
import type { AppContext } from '../app/context.ts';

/** Fills the menu. */
export async function examplesMenu(menu: HTMLElement, { files, actions, commands }: AppContext) {
  const examples = await files.examples();
  const begin = commands.find(({ id }) => id === 'new-mesh');
  menu.replaceChildren(
    element(
      'button.new-mesh',
      {
        role: 'menuitem',
        'aria-haspopup': 'dialog',
        onclick: () => {
          menu.hidePopover();
          begin?.action();
        },
      },
      entry('New mesh', 'A grid, a vault, a dome, hexagons and others, in sizes of your choice.'),
    ),
    element(
      'a',
      { role: 'menuitem', href: './gallery.html' },
      entry('Gallery', 'All examples with pictures of their start and end, figure by figure.'),
    ),
    ...examples.map((example) =>
      element(
        'button',
        {
          role: 'menuitem',
          onclick: () => {
            menu.hidePopover();
            void actions.reportErrors(files.openExample(example));
          },
        },
        // Loaded lazily when the menu opens; not available offline.
        element('img', {
          ...(navigator.onLine && {
            src: new URL(`pictures/${example.id}-end.webp`, document.baseURI).href,
          }),
          alt: '',
          width: 72,
          height: 52,
          loading: 'lazy',
        }),
        entry(example.title, example.summary),
      ),
    ),
  );
}

function entry(title: string, text: string) {
  return element('span.entry', element('strong', title), element('span', text));
}

/** Returns the permanent fragment of an example, see `share-link.ts`. */
export const linkToExample = (id: string) => `#example=${id}`;
