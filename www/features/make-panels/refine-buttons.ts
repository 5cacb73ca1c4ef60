/** The buttons that change the mesh, in the mesh tools. */

import { button } from '../../ui/controls/fields.ts';
import { byId } from '../../ui/dom.ts';
import { isMeshLocked } from './buttons.ts';
import { openRefine } from './refine-dialog.ts';
import { openEdit } from './refine-operation.ts';
import type { AppContext } from '../../app/context.ts';

export function addButtons(app: AppContext) {
  const { store, actions } = app;
  const offer = (label: string, open: () => unknown) =>
    button(label, () => actions.reportErrors(open()), { 'aria-haspopup': 'dialog' });
  const buttons = [offer('Refine', () => openRefine(app)), offer('Edit mesh', () => openEdit(app))];
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
