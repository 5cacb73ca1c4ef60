/** The button that opens the variations, in the mesh tools. */

import { isHard } from '../../store/state.ts';
import { button } from '../../ui/controls/fields.ts';
import { byId } from '../../ui/dom.ts';
import type { AppContext } from '../../app/context.ts';

export function offerVariations(app: AppContext) {
  const { store, actions } = app;
  const open = button('Variations', () =>
    actions.reportErrors(import('./variations-panel.ts').then((it) => it.toggleVariations(app))),
  );
  byId('mesh-tools').prepend(open);
  store.subscribe(['document', 'numbers', 'running'], ({ document: scene, numbers, running }) => {
    open.hidden = !scene?.constraints.some(isHard) && !scene?.variants.length;
    open.disabled = running || !(numbers?.exact?.met || scene?.variants.length);
    open.title = open.disabled
      ? 'Available once the exact constraints are met'
      : 'Other shapes that are as exact as this one';
  });
}
