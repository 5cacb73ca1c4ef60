/** The menu of the view: directions, projection, and what is drawn besides the model. */

import { isEnabled, press } from '../../store/press.ts';
import { placeMenu } from '../../ui/controls/menu.ts';
import { element } from '../../ui/dom.ts';
import { keyName } from '../../ui/keys.ts';
import { keptViews } from './kept-views.ts';
import type { AppContext } from '../../app/context.ts';

/**
 * Fills the menu.
 * @param opener the button that opens it
 */
export function viewMenu(menu: HTMLElement, opener: HTMLElement, app: AppContext) {
  const { store, commands } = app;
  const button = (id: string, label: string, closes = false) => {
    const command = commands.find((known) => known.id === id);
    if (!command) throw new Error(`no command is called ${id}`);
    const made = element(
      'button',
      {
        class: id,
        title: command.keys.map(keyName).join(', '),
        onclick: () => {
          press(command, store);
          if (closes) menu.hidePopover();
        },
      },
      label,
    );
    const [key] = command.keys;
    if (command.pressed && key) made.append(element('kbd', keyName(key)));
    const { pressed } = command;
    if (pressed)
      store.subscribe(['parallel', 'display', 'tape', 'section'], (state) =>
        made.setAttribute('aria-pressed', `${pressed(state)}`),
      );
    store.subscribe(store.steady, (state) => {
      made.disabled = !isEnabled(command, state);
    });
    return made;
  };
  const sides = commands.flatMap(({ id }) => /^view-(.*)/.exec(id)?.slice(1) ?? []);
  const views = sides.map((name) => button(`view-${name}`, name[0].toUpperCase() + name.slice(1)));
  menu.replaceChildren(
    element('div.view-cross', { role: 'group', 'aria-label': 'Look from' }, ...views),
    button('parallel', 'Parallel projection'),
    button('ghost', 'Original ghost'),
    button('ground', 'Ground grid'),
    button('tape', 'Measure a distance', true),
    button('section', 'Section plane'),
    button('curvature', 'Curvature', true),
    button('turn-slowly', 'Turn slowly', true),
    keptViews(app),
  );
  placeMenu(menu, () => opener);
}
