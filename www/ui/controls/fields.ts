/** Common buttons and fields. */

import { element, icon, type Attributes } from '../dom.ts';

/** Value, label and optional tooltip of an option. */
type Option = readonly string[];

export const button = (label: string, onclick: () => unknown, attributes: Attributes = {}) =>
  element('button', { class: 'bordered', onclick, ...attributes }, label);

/** Makes a button with a cross that closes or removes something. */
export const closeButton = (label: string, onclick: () => unknown, attributes: Attributes = {}) =>
  element('button.tiny', { 'aria-label': label, onclick, ...attributes }, icon('close'));

/** @param attributes of the label */
export function checkbox(
  label: string,
  onchange: (checked: boolean) => unknown,
  attributes: Attributes = {},
) {
  const box = element('input', { type: 'checkbox', onchange: () => onchange(box.checked) });
  return { box, label: element('label', attributes, box, label) };
}

/** Makes a list box for one choice. */
export function choice(
  attributes: Attributes,
  onchange: (value: string) => unknown,
  options: Option[] = [],
) {
  const select = element('select', { ...attributes, onchange: () => onchange(select.value) });
  setOptions(select, options);
  return select;
}

/** Sets the options of a list if they differ, and keeps the chosen one. */
export function setOptions(select: HTMLSelectElement, options: Option[]) {
  const before = select.value;
  const same = ([value, label]: Option, i: number) =>
    select.options[i]?.value === value && select.options[i].label === label;
  if (options.length === select.options.length && options.every(same)) return;
  select.replaceChildren(
    ...options.map(([value, label, title = '']) => element('option', { value, title }, label)),
  );
  if (options.some(([value]) => value === before)) select.value = before;
}

/**
 * Makes a field for a non-negative number, reported on change. Invalid input is reverted.
 * @param onempty called for a field that is emptied; without it, this is invalid too
 */
export function amountField(
  name: string,
  onchange: (value: number) => unknown,
  attributes: Attributes = {},
  onempty?: () => unknown,
) {
  const field = element('input', {
    ...{ type: 'number', min: '0', step: 'any', 'aria-label': name, ...attributes },
    oninput: () => {
      typed = true;
    },
    onchange: () => {
      if (!field.validity.valid) field.value = shown;
      else if (field.value !== '') onchange(field.valueAsNumber);
      else if (onempty) onempty();
      else field.value = shown;
      typed = false;
    },
    onkeydown: (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || !typed) return;
      event.stopPropagation();
      typed = false;
      field.value = shown;
    },
    // Input that ends at the value shown before changes nothing.
    onblur: () => {
      if (typed) field.value = shown;
      typed = false;
    },
  });
  let typed = false;
  let shown = field.value;
  return {
    field,
    /** Shows a value, null for none, unless it is being typed. */
    show(value: number | null) {
      shown = value === null ? '' : String(value);
      if (!typed) field.value = shown;
    },
  };
}
