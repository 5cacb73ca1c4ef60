/** A labelled field for a size that the solver declares. */

import { useState } from 'preact/hooks';
import type { Size } from '../../pkg/engine/shape_up.js';

/**
 * @param value the first one
 * @param unit of lengths
 * @param onSize called for each input; `problem` says what is wrong with it, if anything is
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
  const isLength = of === 'length';
  return (
    <label>
      <span>{label}</span>
      <input
        type="number"
        min={String(least)}
        max={String(most)}
        step={isLength ? 'any' : '1'}
        inputMode={isLength ? 'decimal' : 'numeric'}
        required
        value={text}
        onInput={({ currentTarget: field }) => {
          // A number that is being typed may have no value yet.
          if (!field.validity.badInput) setText(field.value);
          onSize(field.valueAsNumber, field.validationMessage);
        }}
      />
      <span class="unit" data-of={of}>
        {{ length: unit, degrees: '°', count: '' }[of]}
      </span>
    </label>
  );
}
