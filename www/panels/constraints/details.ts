/** The details of a constraint: its drawing, requirement and parameters. Changes act at once. */

import { button } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { Parameters } from '../../ui/kinds/parameters.ts';
import { sketch } from '../../ui/kinds/sketch.ts';
import { exactActions } from '../../store/actions/exact-actions.ts';
import { easedOf, requirementOf } from './requirement.ts';
import type { ConstraintRow } from '../../solver/types.ts';
import type { Store } from '../../store/state.ts';
import type { Actions } from '../../store/actions.ts';
import type { SolverClient } from '../../solver/solver-client.ts';

/** @param own actions of the list */
export function detailsOf(
  row: ConstraintRow,
  name: string,
  store: Store,
  actions: Actions,
  solver: SolverClient,
  { select, rename }: { select: () => void; rename: () => void },
): Node[] {
  const { kinds, model, document } = store.get();
  const kind = kinds.find(({ id }) => id === row.kind);
  if (!kind || !model) return [];
  const parameters = new Parameters(kind.params, row.params, model, {
    name,
    changed: (id, value) =>
      actions.edit({ setConstraint: { index: row.index, params: { [id]: value } } }, (error) => {
        parameters.restore(row.params);
        return parameters.refuse(error);
      }),
  });
  const duplicate = () => actions.edit({ duplicateConstraint: { index: row.index } });
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
