/** A field for a value of a measure. */

import { useState } from 'preact/hooks';
import { NumberInput, numberIn } from '../../ui/components/number-input.tsx';
import type { ComponentProps } from 'preact';

export function ValueField({
  shown,
  unit,
  isPositive = false,
  onValue,
  ...rest
}: Omit<ComponentProps<'input'>, 'value' | 'type' | 'role' | 'min' | 'max' | 'step'> & {
  shown: string;
  /** the symbol of its unit if that is one of length */
  unit: string;
  /** whether 0 is refused, too */
  isPositive?: boolean;
  /** @param value null if the field is empty */
  onValue: (value: number | null) => unknown;
}) {
  /** Input that is not accepted yet. */
  const [typed, setTyped] = useState<string | null>(null);
  const accepted = { unit, min: 0 };

  function accept(input: HTMLInputElement) {
    const value = numberIn(input, accepted);
    if (value === 0 && isPositive) input.setCustomValidity('Expected a number above 0.');
    if (!input.reportValidity()) return;
    setTyped(null);
    onValue(value);
  }

  return (
    <NumberInput
      accepted={accepted}
      value={typed ?? shown}
      onInput={({ currentTarget }) => {
        currentTarget.setCustomValidity('');
        setTyped(currentTarget.value);
      }}
      onChange={({ currentTarget }) => accept(currentTarget)}
      onKeyDown={(event) => {
        if (event.key !== 'Escape' || typed === null) return;
        event.stopPropagation();
        event.currentTarget.setCustomValidity('');
        event.currentTarget.value = shown;
        setTyped(null);
      }}
      onBlur={({ currentTarget }) => {
        currentTarget.setCustomValidity('');
        setTyped(null);
      }}
      {...rest}
    />
  );
}
