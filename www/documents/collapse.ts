/**
 * Message after a run that has collapsed the mesh, with offers of what to do, and the question before
 * such a shape is exported.
 */

import { openDialog } from '../ui/controls/dialog.ts';
import { button } from '../ui/controls/fields.ts';
import { element } from '../ui/dom.ts';
import { isLocked } from '../store/panels-card.ts';
import { untilChanged } from '../store/until-changed.ts';
import { oneAtATime } from '../ui/once.ts';
import type { AppContext } from '../app/context.ts';

/**
 * Reports it until another edit or run.
 * @param collapse description, as the end of a sentence
 */
export function reportCollapse({ store, alerts, actions }: AppContext, collapse: string) {
  const text = `While iterating, ${collapse}.`;
  actions.setStatus(text);
  const withdraw = alerts.notice(
    text,
    { label: 'Undo', action: () => actions.undo() },
    ...(isLocked(store.get(), 'weights')
      ? []
      : [
          {
            label: 'Hold near original positions',
            action: async () => {
              await actions.undo();
              // The run before may have collapsed the shape as well, as one of many single steps has.
              if (await actions.ask.collapse()) await actions.reset();
              if ((await actions.edit('holdCloser')) !== undefined) actions.run();
            },
          },
        ]),
  );
  untilChanged(store, withdraw);
}

/** Asks whether to export a collapsed shape, unless the question is open already. */
export const askToExport = oneAtATime(askOnce);

/** @param collapse description, as the end of a sentence */
function askOnce(collapse: string): Promise<boolean> {
  const answer = (value: string) => () => dialog.close(value);
  const dialog = openDialog(
    { id: 'export-anyway', title: 'Export this shape?' },
    element(
      'div.dialog-body',
      element('p', `While iterating, ${collapse}. You probably do not want to export this shape.`),
      element(
        'div.dialog-foot',
        button('Export anyway', answer('export')),
        button('Cancel', answer(''), { class: 'primary' }),
      ),
    ),
  );
  return new Promise((resolve) =>
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'export')),
  );
}
