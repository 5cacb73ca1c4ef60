/** A field for a value of a measure, with a point or a comma. */

import { useState } from 'preact/hooks';
import type { ComponentProps } from 'preact';

/** A decimal number as it is typed or shown, with a minus sign or a hyphen. */
const DECIMAL = /^[+−-]?(\d+[.,]?\d*|[.,]\d+)(e[+−-]?\d+)?$/i;

export function ValueField({
  shown,
  isPositive = false,
  onValue,
  ...rest
}: Omit<ComponentProps<'input'>, 'value' | 'type' | 'role'> & {
  shown: string;
  /** whether 0 is refused, too */
  isPositive?: boolean;
  /** @param value null if the field is empty */
  onValue: (value: number | null) => unknown;
}) {
  /** Input that is not accepted yet. */
  const [typed, setTyped] = useState<string | null>(null);

  function accept(input: HTMLInputElement) {
    const value = numberIn(input.value);
    if (value === undefined || (value === 0 && isPositive)) {
      const least = isPositive ? 'above' : 'from';
      input.setCustomValidity(`“${input.value}” is not a number ${least} 0.`);
      input.reportValidity();
      return;
    }
    setTyped(null);
    onValue(value);
  }

  return (
    <input
      type="text"
      inputMode="decimal"
      autocomplete="off"
      class="number"
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

/** Returns the number of a text; null if it is empty, undefined if it has none from zero. */
function numberIn(text: string) {
  const trimmed = text.trim();
  if (trimmed === '') return null;
  const value = DECIMAL.test(trimmed)
    ? Number(trimmed.replace(',', '.').replaceAll('−', '-'))
    : NaN;
  return value >= 0 && Number.isFinite(value) ? value : undefined;
}
