/**
 * The details of a constraint in its row: drawing, requirement and parameters, and the field of its
 * name. Changes act at once.
 */

import '../../ui/styles/lists.css';
import { button, amountField, choice } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { count, length as lengthText, lengthUnit } from '../../ui/format.ts';
import { Parameters } from '../../ui/kinds/parameters.ts';
import { sketch } from '../../ui/kinds/sketch.ts';
import type { ConstraintRow, Require } from '../../solver/types.ts';
import type { Actions } from '../../store/actions.ts';
import type { Store } from '../../store/state.ts';

/** @param own actions of the list */
export function detailsOf(
  row: ConstraintRow,
  name: string,
  store: Store,
  actions: Actions,
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
    requirementOf(row, name, store, actions),
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

/** The requirements: id, label, meaning. */
const OPTIONS = [
  ['soft', 'Soft', 'Balanced against the other goals by its weight'],
  ['within', 'Within', 'No vertex is farther from the shape than this length'],
  ['exact', 'Exact', 'Met exactly, as close to the original as possible'],
];

/** The requirement of a constraint: soft, within a length, or exact. */
function requirementOf(
  { index, require }: ConstraintRow,
  name: string,
  store: Store,
  actions: Actions,
) {
  const { document } = store.get();
  const length = typeof require === 'object' ? require.within : (document?.tolerance ?? 0);
  const { unit, factor } = lengthUnit(length, document?.units ?? '');
  const ask = (require: Require) => actions.exact.require(index, require);
  // The tolerance at the press: the row is not made again when that changes.
  const toTolerance = () => ({ within: store.get().document?.tolerance ?? length });
  const within = amountField(`${name}: within`, (value) => ask({ within: value / factor }));
  within.show(Number((length * factor).toPrecision(6)));
  const required = typeof require === 'object' ? 'within' : require;
  const select = choice(
    {
      'aria-label': `${name}: required`,
      title: OPTIONS.find(([id]) => id === required)?.[2] ?? '',
    },
    (value) => ask(value === 'within' ? toTolerance() : (value as Require)),
    OPTIONS,
  );
  select.value = required;
  const isTooLarge = Boolean(document?.tooLargeForExact);
  for (const option of select.options) {
    option.disabled = isTooLarge && option.value === 'exact' && required !== 'exact';
  }
  return element(
    'label.requirement',
    'Required',
    select,
    ...(required === 'within' ? [within.field, element('span', unit)] : []),
    ...(isTooLarge
      ? [element('small', 'The mesh is too large for Exact. Within is possible.')]
      : []),
  );
}

/**
 * Describes the panels with an eased requirement.
 * @param units of the mesh
 */
function easedOf(eased: ConstraintRow['eased'], units: string) {
  if (!eased) return [];
  const within = lengthText(eased.within, units);
  const words = `${count(eased.panels, 'panel')} only within ${within}, so that no face folds.`;
  return [element('p.quiet', words)];
}

/**
 * Replaces the button that shows the name by a field. Enter or leaving the field accepts the name,
 * Escape restores the old one; an empty name means the label of the kind.
 * @param opener the button that shows the name
 * @param name of the row, empty when it has none
 * @param label of its kind
 */
export function editName(
  opener: HTMLElement,
  name: string,
  label: string,
  rename: (name: string) => void,
) {
  const field = element('input.rename', {
    type: 'text',
    'aria-label': 'Name of the constraint',
    placeholder: label,
    value: name,
    maxlength: '80',
    autocomplete: 'off',
  });
  let done = false;
  const finish = (keep: boolean) => {
    if (done) return;
    done = true;
    const focused = document.activeElement === field;
    const now = field.value.trim();
    field.replaceWith(opener);
    if (focused) opener.focus();
    if (keep && now !== name) rename(now === label ? '' : now);
  };
  field.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
    finish(event.key === 'Enter');
  });
  field.addEventListener('blur', () => finish(true));
  opener.replaceWith(field);
  field.focus();
  field.select();
}
