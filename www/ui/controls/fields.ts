/** Common buttons. */

import { element, icon, type Attributes } from '../dom.ts';

export const button = (label: string, onclick: () => unknown, attributes: Attributes = {}) =>
  element('button', { class: 'bordered', onclick, ...attributes }, label);

/** Makes a button with a cross that closes or removes something. */
export const closeButton = (label: string, onclick: () => unknown, attributes: Attributes = {}) =>
  element('button.tiny', { 'aria-label': label, onclick, ...attributes }, icon('close'));
