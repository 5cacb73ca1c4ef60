/** The details of a constraint: its drawing, requirement and parameters. Changes act at once. */

import { button } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';
import { Parameters } from '../../ui/kinds/parameters.js';
import { sketch } from '../../ui/kinds/sketch.js';
import { exactActions } from '../../store/actions/exact-actions.js';
import { easedOf, requirementOf } from './requirement.js';

/** @typedef {import("../../solver/messages.js").ConstraintRow} ConstraintRow */

/**
 * @param {ConstraintRow} row
 * @param {string} name
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../store/actions.js").Actions} actions
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {{ select: () => void, rename: () => void }} own actions of the list
 * @returns {Node[]}
 */
export function detailsOf(row, name, store, actions, solver, { select, rename }) {
  const { kinds, model, document } = store.get();
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
  const duplicate = () => actions.edit({ type: 'duplicateConstraint', index: row.index });
  return [
    sketch(kind.sketch),
    element('p.quiet', kind.summary),
    requirementOf(row, name, store, exactActions(solver, actions)),
    ...easedOf(row.eased, document?.units ?? ''),
    parameters.element,
    element(
      'div.row-buttons',
      button('Select', select, { 'aria-label': `${name}: select what it acts on` }),
      button('Duplicate', duplicate, { 'aria-label': `${name}: duplicate` }),
      button('Rename', rename, { 'aria-label': `${name}: rename` }),
    ),
  ];
}
