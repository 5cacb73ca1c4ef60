/** The buttons that change the mesh, in the mesh tools. */

import { button } from '../../ui/controls/fields.js';
import { byId } from '../../ui/dom.js';
import { isMeshLocked } from './buttons.js';

/** @param {import("../../app/context.js").AppContext} app */
export function addButtons(app) {
  const { store, actions } = app;
  const offer = (/** @type {string} */ label, /** @type {() => Promise<unknown>} */ open) =>
    button(label, () => actions.reportErrors(open()), { 'aria-haspopup': 'dialog' });
  const buttons = [
    offer('Refine', () => import('./refine-dialog.js').then((it) => it.openRefine(app))),
    offer('Edit mesh', () => import('./refine-operation.js').then((it) => it.openEdit(app))),
  ];
  byId('mesh-tools').prepend(...buttons);
  store.subscribe(['model', 'document'], (state) => {
    const { model, document: scene } = state;
    const locked = isMeshLocked(state);
    for (const one of buttons) {
      one.disabled = !model?.faces || model.tets > 0 || !scene || locked;
      one.title = locked ? 'Locked by the lesson' : '';
    }
  });
}
