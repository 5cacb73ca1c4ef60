/** Common buttons and fields. */

import { element, icon, type Attributes } from '../dom.ts';

/** Value, label and optional tooltip of an option. */
type Option = readonly string[];

export const button = (label: string, onclick: () => unknown, attributes: Attributes = {}) =>
  element('button', { class: 'bordered', onclick, ...attributes }, label);

/** Makes a button with a cross that closes or removes something. */
export const closeButton = (label: string, onclick: () => unknown, attributes: Attributes = {}) =>
  element('button.tiny', { 'aria-label': label, onclick, ...attributes }, icon('close'));

/** Makes a list box for one choice. */
export function choice(
  attributes: Attributes,
  onchange: (value: string) => unknown,
  options: Option[] = [],
) {
  const select = element(
    'select',
    { ...attributes, onchange: () => onchange(select.value) },
    ...options.map(([value, label, title = '']) => element('option', { value, title }, label)),
  );
  return select;
}
