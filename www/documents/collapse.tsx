/**
 * Message after a run that has collapsed the mesh, with offers of what to do, and the question before
 * such a shape is exported.
 */

import { useLayoutEffect } from 'preact/hooks';
import { isLocked } from '../store/panels-card.ts';
import { showDialog, type InDialog } from '../store/show-dialog.tsx';
import { untilChanged } from '../store/until-changed.ts';
import { Button } from '../ui/components/buttons.tsx';
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
function askOnce(app: AppContext, collapse: string): Promise<boolean> {
  return new Promise((resolve) => {
    function Question({ close }: InDialog) {
      // However it is closed, and however soon.
      useLayoutEffect(() => () => resolve(false), []);
      const anyway = () => {
        resolve(true);
        close();
      };
      return (
        <div class="dialog-body">
          <p>While iterating, {collapse}. You probably do not want to export this shape.</p>
          <div class="dialog-buttons">
            <Button onClick={anyway}>Export anyway</Button>
            <Button class="primary" onClick={close}>
              Cancel
            </Button>
          </div>
        </div>
      );
    }
    showDialog(app, { id: 'export-anyway', title: 'Export this shape?' }, Question);
  });
}
