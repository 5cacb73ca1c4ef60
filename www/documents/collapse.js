/**
 * Message for a run that was stopped because the mesh collapsed, with offers of what to do, and the
 * question before such a shape is exported.
 */

import { openDialog } from '../ui/controls/dialog.js';
import { button } from '../ui/controls/fields.js';
import { element } from '../ui/dom.js';

/**
 * @param {import("../app/context.js").AppContext} app
 * @param {string} collapse description, as the end of a sentence
 */
export function reportCollapse({ alerts, actions }, collapse) {
  const text = `Stopped: ${collapse}.`;
  actions.setStatus(text);
  alerts.notice(
    text,
    { label: 'Undo', action: () => actions.undo() },
    {
      label: 'Increase closeness',
      action: async () => {
        await actions.undo();
        if ((await actions.edit({ type: 'holdCloser' })) !== undefined) actions.run();
      },
    },
    { label: 'Continue anyway', action: () => actions.run(true) },
  );
}

/**
 * Asks whether to export a collapsed shape.
 * @param {string} collapse description, as the end of a sentence
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
        button('Export anyway', answer('export')),
        button('Cancel', answer(''), { class: 'primary' }),
      ),
    ),
  );
  return new Promise((resolve) =>
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'export')),
  );
}
