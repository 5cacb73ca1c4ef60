/**
 * A field for a number as people type it: `1.5`, `1,5`, `1/3`, `20 cm` where it has a unit of length,
 * `+0.5` to add to what it has.
 */

import { brief, readLength, rounded } from '../words.ts';
import type { ComponentProps, Ref } from 'preact';

/** Significant digits of decimals, which sums of them keep. */
const DIGITS = 15;

/** What a field accepts. */
export interface Accepted {
  /** the symbol of its unit if that is one of length */
  unit?: string;
  min?: number;
  max?: number;
  /** whether only whole numbers are accepted */
  isWhole?: boolean;
}

/** Returns the number in a field; null if it is empty or invalid, which its validity then says. */
export function numberIn(field: HTMLInputElement, accepted: Accepted, present = 0): number | null {
  const text = field.value.trim();
  const [number, problem] = text === '' ? [null, ''] : readIn(text, accepted, present);
  field.setCustomValidity(problem);
  return problem ? null : number;
}

/** Returns the number of a text, and what is wrong with it. */
function readIn(
  text: string,
  { unit = '', min = -Infinity, max = Infinity, isWhole = false }: Accepted,
  present: number,
): [number, string] {
  try {
    const { by, length } = readLength(text, unit);
    const number = by ? present + length : length;
    if (number < min) return [number, `Expected at least ${brief(min)}.`];
    if (number > max) return [number, `Expected at most ${brief(max)}.`];
    return [number, isWhole && !Number.isInteger(number) ? 'Expected a whole number.' : ''];
  } catch (error) {
    return [NaN, error instanceof Error ? error.message : String(error)];
  }
}

/** @param props.accepted for the arrow keys, which change the number by one */
export function NumberInput({
  accepted,
  field,
  onKeyDown,
  ...rest
}: Omit<ComponentProps<'input'>, 'type' | 'role' | 'min' | 'max' | 'step'> & {
  accepted: Accepted;
  field?: Ref<HTMLInputElement>;
}) {
  return (
    <input
      ref={field}
      type="text"
      role="spinbutton"
      inputMode={accepted.isWhole ? 'numeric' : 'decimal'}
      autocomplete="off"
      class="number"
      onKeyDown={(event) => {
        onKeyDown?.(event);
        const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (!by || event.defaultPrevented) return;
        event.preventDefault();
        step(event.currentTarget, by, accepted);
      }}
      {...rest}
    />
  );
}

/** Changes the number in a field, as if it had been typed and entered. */
function step(field: HTMLInputElement, by: number, accepted: Accepted) {
  const { min = -Infinity, max = Infinity } = accepted;
  const number = numberIn(field, accepted) ?? 0;
  const next = rounded(number + by, DIGITS);
  if (next < min || next > max) return;
  field.value = String(next);
  field.dispatchEvent(new Event('input', { bubbles: true }));
  field.dispatchEvent(new Event('change', { bubbles: true }));
}
