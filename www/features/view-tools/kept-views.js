/** The views that the user has kept: the camera of each, saved with the model. */

import { closeButton } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';
import { fly } from '../../viewport/flight.js';

/** Maximum number of kept views. */
const MOST = 9;

/** @param {Pick<import("../../app/context.js").AppContext, "store" | "actions" | "viewport">} app */
export function keptViews({ store, actions, viewport }) {
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
