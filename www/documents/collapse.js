/**
 * A run that took the mesh apart: it was stopped, and what can be done is offered. An export of such
 * a shape asks first.
 */

import { openDialog } from '../ui/controls/dialog.js';
import { element } from '../ui/dom.js';

/**
 * @param {import("../app/context.js").AppContext} app
 * @param {string} collapse how, as the end of a sentence
 */
export function reportCollapse({ store, solver, alerts, actions }, collapse) {
  const text = `Stopped: ${collapse}.`;
  store.set({ status: text });
  alerts.notice(
    text,
    { label: 'Undo', action: () => actions.undo() },
    {
      label: 'Hold closer',
      action: async () => {
        await actions.undo();
        if ((await actions.edit({ type: 'holdCloser' })) !== undefined)
          solver.send({ type: 'run' });
      },
    },
    { label: 'Go on', action: () => solver.send({ type: 'run', goOn: true }) },
  );
}

/**
 * Asks whether a shape that has collapsed shall be exported as it is.
 * @param {string} collapse how, as the end of a sentence
 * @returns {Promise<boolean>}
 */
export function askToExport(collapse) {
  const answer = (/** @type {string} */ value) => () => dialog.close(value);
  const dialog = openDialog(
    { id: 'export-anyway', title: 'Export this shape?' },
    element(
      'div.dialog-body',
      element('p', `In the last run ${collapse}. You probably do not want to export this shape.`),
      element(
        'div.dialog-foot',
        element('button.bordered', { onclick: answer('export') }, 'Export anyway'),
        element('button.primary', { onclick: answer('') }, 'Cancel'),
      ),
    ),
  );
  return new Promise((resolve) =>
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'export')),
  );
}
