/** A labelled field for a size that the solver declares. */

import { element } from '../dom.ts';
import type { Size } from '../../pkg/engine/shape_up.js';

/** @param shown `unit`: of lengths */
export function sizeField(
  { label, of, least, most }: Pick<Size, 'label' | 'of' | 'least' | 'most'>,
  { value, unit, onchange }: { value: number; unit: string; onchange: () => unknown },
) {
  const length = of === 'length';
  const symbol = { length: unit, degrees: '°', count: '' }[of];
  const field = element('input', {
    ...{ type: 'number', min: String(least), max: String(most), value: String(value) },
    ...{ step: length ? 'any' : '1', inputmode: length ? 'decimal' : 'numeric' },
    required: true,
    oninput: onchange,
  });
  return element(
    'label',
    element('span', label),
    field,
    element('span.unit', { 'data-of': of }, symbol),
  );
}
