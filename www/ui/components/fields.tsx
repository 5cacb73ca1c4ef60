/** Common fields. */

import { useLayoutEffect, useRef } from 'preact/hooks';
import { NumberInput, numberIn, type Accepted } from './number-input.tsx';
import { useEntered } from './use-entered.ts';
import { useTyped } from './use-typed.ts';
import { readLength } from '../words.ts';
import type { ComponentProps } from 'preact';

/**
 * A field for a number, not negative unless `min` says so, reported on change. It shows what was
 * entered until the edit that `onAmount` or `onEmpty` returns has settled. Invalid input is reverted
 * when the field is left, and so is input that Escape ends.
 */
export function AmountField({
  name,
  value,
  shown = value === null ? '' : String(value),
  onAmount,
  onAddToEach,
  onEmpty,
  isReplaced = false,
  unit,
  min = 0,
  max,
  isWhole,
  isPositive,
  step,
  ...rest
}: Omit<ComponentProps<'input'>, 'value' | 'type' | 'role' | 'min' | 'max' | 'step'> &
  Omit<Accepted, 'present' | 'addsToEach'> & {
    /** its accessible name, unless a label names it */
    name?: string;
    /** null for none */
    value: number | null;
    /** the value in words, if other than all its digits */
    shown?: string;
    onAmount: (to: number) => unknown;
    /** called for what is added to each of the numbers that it stands for */
    onAddToEach?: (by: number) => unknown;
    /** called for a field that is emptied; without it, the value comes back */
    onEmpty?: () => unknown;
    /** whether what is typed next replaces a value that comes while the field has the focus */
    isReplaced?: boolean;
  }) {
  const [typed, setTyped] = useTyped<string | null>(null);
  const { over, enter } = useEntered<number | null>();
  const field = useRef<HTMLInputElement>(null);
  /** Whether Enter was pressed after the last input. */
  const isEntered = useRef(false);
  const addsToEach = onAddToEach !== undefined;
  const accepted = { unit, min, max, isWhole, isPositive, step, present: over(value), addsToEach };
  const textNow = () => (over(value) === value ? shown : String(over(value) ?? ''));
  const text = textNow();
  useLayoutEffect(() => {
    const { current } = field;
    if (isReplaced && typed === null && document.activeElement === current) current?.select();
  }, [text]);
  const revert = () => {
    setTyped(null);
    if (!field.current) return;
    // A rejected text is no value that could change.
    field.current.value = textNow();
    numberIn(field.current, accepted);
  };
  return (
    <NumberInput
      field={field}
      accepted={accepted}
      aria-label={name}
      value={typed ?? text}
      onInput={({ currentTarget }) => {
        isEntered.current = false;
        setTyped(currentTarget.value);
      }}
      onChange={({ currentTarget }) => {
        // The word that stands there when it is empty can be typed, too; a number there is one.
        const isPlaceholder = currentTarget.value.trim().toLowerCase() === rest.placeholder;
        const isWord = isPlaceholder && numberIn(currentTarget, accepted) === null;
        if (onEmpty && isWord) currentTarget.value = '';
        const to = numberIn(currentTarget, accepted);
        // What is wrong is said until the field is left; leaving it is not held up.
        if (isEntered.current && !currentTarget.reportValidity()) return;
        if (to !== null) enter(to, onAmount(to));
        else if (currentTarget.validity.valid && currentTarget.value.trim())
          onAddToEach?.(readLength(currentTarget.value, unit ?? '').length);
        else if (onEmpty && currentTarget.validity.valid) enter(null, onEmpty());
        revert();
      }}
      onKeyDown={(event) => {
        if (event.key === 'Enter') isEntered.current = true;
        if (event.key !== 'Escape' || typed === null) return;
        event.stopPropagation();
        revert();
      }}
      // Input that ends at the value shown before changes nothing.
      onBlur={() => typed !== null && revert()}
      {...rest}
    />
  );
}

/** Value, label and optional tooltip. */
type Option = readonly [value: string, label: string, title?: string];

/** A list box for one choice. */
export function Choice({
  value,
  options,
  onChoose,
  isDisabled,
  ...rest
}: Omit<ComponentProps<'select'>, 'value' | 'options' | 'role'> & {
  value: string;
  options: readonly Option[];
  onChoose: (value: string) => unknown;
  isDisabled?: (value: string) => boolean;
}) {
  return (
    <select
      value={value}
      onChange={({ currentTarget }) => {
        const chosen = currentTarget.value;
        // What was chosen is shown when it is in effect.
        currentTarget.value = value;
        onChoose(chosen);
      }}
      {...rest}
    >
      {options.map(([id, label, title = '']) => (
        <option key={id} value={id} title={title} disabled={isDisabled?.(id)}>
          {label}
        </option>
      ))}
    </select>
  );
}

/** A check box with its label. */
export function Checkbox({
  label,
  checked,
  onCheck,
  ...rest
}: Omit<ComponentProps<'label'>, 'label'> & {
  label: string;
  checked: boolean;
  onCheck: (checked: boolean) => unknown;
}) {
  return (
    <label {...rest}>
      <input
        type="checkbox"
        checked={checked}
        onChange={({ currentTarget }) => onCheck(currentTarget.checked)}
      />
      {label}
    </label>
  );
}
