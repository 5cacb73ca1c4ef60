/** The views that the user has kept: the camera of each, saved with the model. */

import { closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { fly } from '../../viewport/flight.ts';
import type { AppContext } from '../../app/context.ts';

/** Maximum number of kept views. */
const MOST = 9;

export function keptViews({
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
