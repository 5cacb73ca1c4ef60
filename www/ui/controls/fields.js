/** Common buttons and fields. */

import { element, icon } from '../dom.js';

/** @typedef {import("../dom.js").Attributes} Attributes */
/** Value, label and optional tooltip of an option. @typedef {readonly string[]} Option */

/**
 * @param {string} label
 * @param {() => unknown} onclick
 * @param {Attributes} [attributes]
 */
export const button = (label, onclick, attributes = {}) =>
  element('button', { class: 'bordered', onclick, ...attributes }, label);

/**
 * Makes a button with a cross that closes or removes something.
 * @param {string} label
 * @param {() => unknown} onclick
 * @param {Attributes} [attributes]
 */
export const closeButton = (label, onclick, attributes = {}) =>
  element('button.tiny', { 'aria-label': label, onclick, ...attributes }, icon('close'));

/**
 * @param {string} label
 * @param {(checked: boolean) => unknown} onchange
 * @param {Attributes} [attributes] of the label
 */
export function checkbox(label, onchange, attributes = {}) {
  const box = element('input', { type: 'checkbox', onchange: () => onchange(box.checked) });
  return { box, label: element('label', attributes, box, label) };
}

/**
 * Makes a list box for one choice.
 * @param {Attributes} attributes
 * @param {(value: string) => unknown} onchange
 * @param {Option[]} [options]
 */
export function choice(attributes, onchange, options = []) {
  const select = element('select', { ...attributes, onchange: () => onchange(select.value) });
  setOptions(select, options);
  return select;
}

/**
 * Sets the options of a list if they differ, and keeps the chosen one.
 * @param {HTMLSelectElement} select
 * @param {Option[]} options
 */
export function setOptions(select, options) {
  const before = select.value;
  const same = (/** @type {Option} */ [value, label], /** @type {number} */ i) =>
    select.options[i]?.value === value && select.options[i].label === label;
  if (options.length === select.options.length && options.every(same)) return;
  select.replaceChildren(
    ...options.map(([value, label, title = '']) => element('option', { value, title }, label)),
  );
  if (options.some(([value]) => value === before)) select.value = before;
}

/**
 * Makes a field for a non-negative number, reported on change. Invalid input is reverted.
 * @param {string} name
 * @param {(value: number) => unknown} onchange
 * @param {Attributes} [attributes]
 */
export function amountField(name, onchange, attributes = {}) {
  const field = element('input', {
    ...{ type: 'number', min: '0', step: 'any', 'aria-label': name, ...attributes },
    oninput: () => {
      typed = true;
    },
    onchange: () => {
      if (field.validity.valid && field.value !== '') onchange(field.valueAsNumber);
      else field.value = shown;
      typed = false;
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
    /** Shows a value, unless it is being typed. @param {number} value */
    show(value) {
      shown = String(value);
      if (!typed) field.value = shown;
    },
  };
}
