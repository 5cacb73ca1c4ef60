/** What opens below a row of the list of constraints: what it asks, and its parameters, which act at once. */

import { element } from '../../ui/dom.js';
import { Parameters } from '../../ui/kinds/parameters.js';
import { sketch } from '../../ui/kinds/sketch.js';

/** @typedef {import("../../solver/messages.js").ConstraintRow} ConstraintRow */

/**
 * @param {ConstraintRow} row
 * @param {string} name
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../store/actions.js").Actions} actions
 * @param {{ select: () => void, rename: () => void }} own what only the list can do
 * @returns {Node[]}
 */
export function detailsOf(row, name, store, actions, { select, rename }) {
  const { kinds, model } = store.get();
  const kind = kinds.find(({ id }) => id === row.kind);
  if (!kind || !model) return [];
  const parameters = new Parameters(kind.params, row.params, model, {
    name,
    changed: (id, value) =>
      actions.edit(
        { type: 'setConstraint', index: row.index, params: { [id]: value } },
        (error) => {
          parameters.restore(row.params);
          return parameters.refuse(error);
        },
      ),
  });
  return [
    sketch(kind.sketch),
    element('p.quiet', kind.summary),
    parameters.element,
    element(
      'div.row-buttons',
      textButton('Select', `${name}: select what it acts on`, select),
      textButton('Duplicate', `${name}: duplicate`, () =>
        actions.edit({ type: 'duplicateConstraint', index: row.index }),
      ),
      textButton('Rename', `${name}: rename`, rename),
    ),
  ];
}

/**
 * @param {string} label
 * @param {string} name for those who do not see where it is
 * @param {() => void} onclick
 */
function textButton(label, name, onclick) {
  return element('button.bordered', { 'aria-label': name, onclick }, label);
}
