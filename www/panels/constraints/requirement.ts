/** The requirement of a constraint: soft, within a length, or exact. Changes act at once. */

import { amountField, choice } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { count, length as lengthText, lengthUnit } from '../../ui/format.ts';
import type { ConstraintRow, Require } from '../../solver/types.ts';
import type { Store } from '../../store/state.ts';

const OPTIONS = [
  ['soft', 'Soft', 'Balanced against the other goals by its weight'],
  ['within', 'Within', 'No vertex is farther from the shape than this length'],
  ['exact', 'Exact', 'Met exactly, as close to the original as possible'],
];

export function requirementOf(
  { index, require }: ConstraintRow,
  name: string,
  store: Store,
  actions: ReturnType<typeof import('../../store/actions/exact-actions.ts').exactActions>,
) {
  const { tolerance, model, document } = store.get();
  const usual = tolerance ?? model?.tolerance ?? 0;
  const length = typeof require === 'object' ? require.within : usual;
  const { unit, factor } = lengthUnit(length, document?.units ?? '');
  const ask = (require: Require) => actions.require(index, require);
  const within = amountField(`${name}: within`, (value) => ask({ within: value / factor }));
  within.show(Number((length * factor).toPrecision(6)));
  const required = typeof require === 'object' ? 'within' : require;
  const select = choice(
    {
      'aria-label': `${name}: required`,
      title: OPTIONS.find(([id]) => id === required)?.[2] ?? '',
    },
    (value) => ask(value === 'within' ? { within: length } : (value as Require)),
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
export function easedOf(eased: ConstraintRow['eased'], units: string) {
  if (!eased) return [];
  const within = lengthText(eased.within, units);
  const words = `${count(eased.panels, 'panel')} only within ${within}: any closer, they would fold.`;
  return [element('p.quiet', words)];
}
