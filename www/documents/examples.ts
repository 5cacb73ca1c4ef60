/** The examples: their menu with pictures, their links, and their statements. */

import { element } from '../ui/dom.ts';
import type { AppContext } from '../app/context.ts';
import type { Example } from '../solver/examples.ts';

/** Fills the menu, and again when it is to open if the examples could not be fetched. */
export function examplesMenu(menu: HTMLElement, app: AppContext) {
  const { files, actions } = app;
  let isFilled = false;
  const fill = async () => {
    const examples = await files.examples();
    menu.replaceChildren(...others, ...examples.map((example) => itemOf(example, menu, app)));
    isFilled = true;
  };
  const others = otherItems(menu, app);
  menu.replaceChildren(...others);
  void actions.reportErrors(fill());
  menu.addEventListener('beforetoggle', ({ newState }) => {
    if (newState === 'open' && !isFilled) void actions.reportErrors(fill());
  });
}

/** What is in the menu beside the examples. */
function otherItems(menu: HTMLElement, { commands }: AppContext) {
  const begin = commands.find(({ id }) => id === 'new-mesh');
  return [
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
      entry('Gallery', 'All examples with pictures of their start and end.'),
    ),
  ];
}

function itemOf(example: Example, menu: HTMLElement, { files, actions }: AppContext) {
  const picture = element('img', {
    src: new URL(`pictures/${example.id}-end.webp`, document.baseURI).href,
    alt: '',
    width: 72,
    height: 52,
    // It is loaded when the menu opens; without a network, only if the gallery has shown it.
    loading: 'lazy',
    onerror: () => (picture.hidden = true),
  });
  return element(
    'button',
    {
      role: 'menuitem',
      onclick: () => {
        menu.hidePopover();
        void actions.reportErrors(files.openExample(example));
      },
    },
    picture,
    entry(example.title, example.summary),
  );
}

function entry(title: string, text: string) {
  return element('span.entry', element('strong', title), element('span', text));
}

/** Returns the permanent fragment of an example, see `share-link.ts`. */
export const linkToExample = (id: string) => `#example=${id}`;
