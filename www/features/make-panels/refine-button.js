/** The button that refines, among those of the model. */

import { button } from '../../ui/controls/fields.js';

/** @param {import("../../app/context.js").AppContext} app */
export function offerRefining(app) {
  const { store, actions } = app;
  const open = button(
    'Refine',
    () => actions.reportErrors(import('./refine-dialog.js').then((it) => it.openRefine(app))),
    { 'aria-haspopup': 'dialog' },
  );
  document.querySelector('#model-panel button[data-command="build"]')?.after(' ', open);
  store.subscribe(['model', 'document'], ({ model, document: scene }) => {
    open.disabled = !model?.faces || model.tets > 0 || !scene;
  });
}
