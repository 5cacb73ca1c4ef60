/** A labelled field for a size that the solver declares. */

import { useState } from 'preact/hooks';
import { NumberInput, numberIn } from './number-input.tsx';
import type { Size } from '../../pkg/engine/shape_up.js';

/**
 * @param value the first one, later the last valid one
 * @param unit of lengths
 * @param onSize called for each input with the last valid value; `problem` says what is wrong with
 *   the input, if anything is
 */
export function SizeField({
  size: { label, of, least, most },
  value,
  unit,
  onSize,
}: {
  size: Pick<Size, 'label' | 'of' | 'least' | 'most'>;
  value: number;
  unit: string;
  onSize: (value: number, problem: string) => unknown;
}) {
  const [text, setText] = useState(String(value));
  const accepted = {
    unit: of === 'length' ? unit : '',
    min: least,
    max: most,
    isWhole: of === 'count',
  };
  return (
    <label>
      <span>{label}</span>
      <NumberInput
        accepted={accepted}
        required
        value={text}
        onInput={({ currentTarget: field }) => {
          setText(field.value);
          onSize(numberIn(field, accepted) ?? value, field.validationMessage);
        }}
      />
      <span class="unit" data-of={of}>
        {{ length: unit, degrees: '°', count: '' }[of]}
      </span>
    </label>
  );
}
