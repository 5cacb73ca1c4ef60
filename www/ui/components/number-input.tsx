/**
 * A field for a number as people type it: `1.5`, `1,5`, `1/3`, `20 cm` where it has a unit of length,
 * `+0.5` to add to what it has.
 */

import { useLayoutEffect, useRef } from 'preact/hooks';
import { brief, readLength } from '../words.ts';
import { nextNumber, type Steps } from './number-steps.ts';
import type { ComponentProps, RefObject } from 'preact';

/** A range that begins here has all numbers above 0. */
const ABOVE_ZERO = 2.2250738585072014e-308;

/** What a field accepts. */
export interface Accepted extends Steps {
  min?: number;
  max?: number;
  /** whether only whole numbers are accepted */
  isWhole?: boolean;
  /** what is added to; nothing is where it is absent */
  present?: number | null;
  /** whether what is added is for each of the numbers that it stands for, and no number of its own */
  addsToEach?: boolean;
}

const isAboveZero = ({ isPositive = false, min }: Accepted) => isPositive || min === ABOVE_ZERO;

/** Returns the number of a text, null if it is empty or added to each number, and what is wrong with it. */
export function readNumber(text: string, accepted: Accepted): [number | null, string] {
  const { unit = '', min = -Infinity, max = Infinity, isWhole, present, addsToEach } = accepted;
  if (text.trim() === '') return [null, ''];
  // To some readers 1,000 is a thousand, to others one.
  if (isWhole && /[.,]/.test(text)) return [null, 'Expected a whole number, such as 1000.'];
  try {
    const { by, length } = readLength(text, unit);
    if (by && addsToEach) return [null, ''];
    if (by && typeof present !== 'number') return [null, 'There is no number to add to.'];
    const number = by ? (present ?? 0) + length : length;
    if (isAboveZero(accepted) && !(number > 0)) return [null, 'Expected a number above 0.'];
    if (number < min) return [null, `Expected at least ${brief(min)}.`];
    if (number > max) return [null, `Expected at most ${brief(max)}.`];
    if (isWhole && !Number.isInteger(number)) return [null, 'Expected a whole number.'];
    return [number, ''];
  } catch (error) {
    return [null, error instanceof Error ? error.message : String(error)];
  }
}

/** Returns the number in a field; null if it is empty or invalid, which its validity then says. */
export function numberIn(field: HTMLInputElement, accepted: Accepted) {
  const [number, problem] = readNumber(field.value, accepted);
  field.setCustomValidity(problem);
  return number;
}

/** Its validity is always that of its text. */
export function NumberInput({
  accepted,
  field,
  onInput,
  onKeyDown,
  ...rest
}: Omit<ComponentProps<'input'>, 'type' | 'role' | 'min' | 'max' | 'step'> & {
  accepted: Accepted;
  field?: RefObject<HTMLInputElement | null>;
}) {
  const own = useRef<HTMLInputElement>(null);
  const place = field ?? own;
  const { unit, min, max, isWhole } = accepted;
  const text = rest.value ?? rest.defaultValue;
  useLayoutEffect(() => {
    if (place.current) numberIn(place.current, accepted);
  }, [text, unit, min, max, isWhole]);
  const [now] = readNumber(typeof text === 'string' ? text : '', accepted);
  // The keys for decimals of a phone have neither signs nor letters.
  const isPlain = !unit && (min ?? -1) >= 0;
  return (
    <input
      ref={place}
      type="text"
      role="spinbutton"
      aria-valuenow={now ?? undefined}
      aria-valuemin={Number.isFinite(min) && min !== ABOVE_ZERO ? min : undefined}
      aria-valuemax={Number.isFinite(max) ? max : undefined}
      inputMode={isPlain ? (isWhole ? 'numeric' : 'decimal') : undefined}
      autocomplete="off"
      class="number"
      onInput={(event) => {
        numberIn(event.currentTarget, accepted);
        onInput?.(event);
      }}
      onKeyDown={(event) => {
        onKeyDown?.(event);
        const by = ({ ArrowUp: 1, ArrowDown: -1 } as const)[event.key];
        const isModified = event.shiftKey || event.altKey || event.ctrlKey || event.metaKey;
        if (!by || isModified || event.defaultPrevented) return;
        event.preventDefault();
        step(event.currentTarget, by, accepted);
      }}
      {...rest}
    />
  );
}

/** Changes the number in a field by a step, as if it had been typed and entered. */
function step(field: HTMLInputElement, by: 1 | -1, accepted: Accepted) {
  const number = numberIn(field, accepted);
  if (!field.reportValidity() || (number === null && accepted.addsToEach)) return;
  const { min = -Infinity, max = Infinity, isWhole } = accepted;
  const how = { ...accepted, isPositive: isAboveZero(accepted) };
  const next = nextNumber(number ?? 0, by, isWhole ? { step: 1 } : how);
  field.value = String(Math.min(Math.max(next, min), max));
  field.dispatchEvent(new Event('input', { bubbles: true }));
  field.dispatchEvent(new Event('change', { bubbles: true }));
}
