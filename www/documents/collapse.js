/**
 * A run that took the mesh apart: it was stopped, and what can be done is offered. An export of such
 * a shape asks first.
 */

import { dialogHead, element } from '../ui/dom.js';
import { part } from '../ui/format.js';

/** @typedef {import("../solver/messages.js").Collapse} Collapse */

/** What happened, as the end of a sentence. @type {Record<Collapse["reason"], (amount: number) => string>} */
const WORDS = {
  shrunk: (amount) =>
    `the mesh shrank to ${amount < 0.01 ? 'a dot' : `${part(amount)} of its size`}`,
  area: (amount) => `${part(amount)} of the faces lost their area`,
  moved: (amount) => `vertices moved by up to ${part(amount)} of the size of the mesh`,
};

/**
 * @param {import("../app/context.js").AppContext} parts
 * @param {Collapse} collapse
 */
export function tellCollapse({ store, solver, alerts, actions }, { reason, amount }) {
  const text = `Stopped: ${WORDS[reason](amount)}.`;
  store.set({ status: text });
  alerts.notice(
    text,
    { label: 'Undo', action: () => actions.undo() },
    {
      label: 'Hold closer',
      action: async () => {
        await actions.undo();
        if ((await actions.edit({ type: 'holdCloser' })) !== undefined)
          solver.tell({ type: 'run' });
      },
    },
    { label: 'Go on', action: () => solver.tell({ type: 'run', goOn: true }) },
  );
}

/**
 * Asks whether a shape that has collapsed shall be exported as it is.
 * @param {Collapse["reason"]} reason
 * @returns {Promise<boolean>}
 */
export function askToExport(reason) {
  const dialog = element('dialog', {
    id: 'export-anyway',
    'aria-labelledby': 'export-anyway-title',
  });
  const answer = (/** @type {string} */ value) => () => dialog.close(value);
  const what = { shrunk: 'shrank', area: 'has faces without an area', moved: 'moved far away' };
  dialog.append(
    dialogHead(dialog, 'export-anyway-title', 'Export this shape?'),
    element(
      'div',
      { class: 'dialog-body' },
      element('p', {}, `The mesh ${what[reason]} in the last run. It is hardly what you want.`),
      element(
        'div',
        { class: 'dialog-foot' },
        element(
          'button',
          { type: 'button', class: 'bordered', onclick: answer('export') },
          'Export anyway',
        ),
        element('button', { type: 'button', class: 'primary', onclick: answer('') }, 'Cancel'),
      ),
    ),
  );
  document.body.append(dialog);
  dialog.showModal();
  return new Promise((resolve) =>
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue === 'export');
    }),
  );
}
