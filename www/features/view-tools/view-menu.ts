/**
 * The menu of the view: directions, projection, what is drawn besides the model, and the views that the
 * user has kept.
 */

import { isEnabled, press } from '../../store/press.ts';
import { closeButton } from '../../ui/controls/fields.ts';
import { placeMenu } from '../../ui/controls/navigation.ts';
import { element } from '../../ui/dom.ts';
import { keyName } from '../../ui/keys.ts';
import { fly } from '../../viewport/camera.ts';
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
    button('turn-slowly', 'Turn slowly', true),
    keptViews(app),
  );
  placeMenu(menu, () => opener);
}

/** Maximum number of kept views. */
const MOST = 9;

/** The views that the user has kept: the camera of each, saved with the model. */
function keptViews({
  store,
  actions,
  viewport,
}: Pick<AppContext, 'store' | 'actions' | 'viewport'>) {
  const list = element('ul');
  const keep = element('button', { onclick: () => keepView() }, 'Keep this view');

  function keepView() {
    const { views, parallel } = store.get();
    const camera = viewport.with((view) => {
      view.arrive();
      return [...view.camera()];
    });
    if (!camera) return;
    const taken = views.map(({ name }) => Number(name.replace(/\D/g, '')));
    const name = `View ${Math.max(0, ...taken) + 1}`;
    actions.look({ views: [...views, { name, camera, parallel }], status: `${name} is kept` });
  }

  store.subscribe(['views'], ({ views }) => {
    keep.disabled = views.length >= MOST;
    const rows = views.map((kept) =>
      element(
        'li',
        element(
          'button',
          {
            onclick: () => {
              actions.look({ parallel: kept.parallel, status: kept.name });
              fly(viewport, (view) => view.placeCamera(Float64Array.from(kept.camera)));
            },
          },
          kept.name,
        ),
        closeButton(`Remove ${kept.name}`, () =>
          actions.look({ views: store.get().views.filter((view) => view !== kept) }),
        ),
      ),
    );
    list.replaceChildren(...rows);
  });
  return element('div.kept-views', { role: 'group', 'aria-label': 'Kept views' }, keep, list);
}
