/** Controls for the parameters of a kind, made from their declaration: forms and their fields. */

import { element } from '../dom.ts';
import {
  AXES,
  FIELD_NAMES,
  axis,
  converted,
  keyOf,
  keyOfValue,
  labelOf,
  unitOf,
  type Model,
} from './parameter-forms.ts';
import type { ParamInfo, ParamValue } from '../../solver/types.ts';

/** Used if no model is open. */
const NO_MODEL: Model = { units: '', meanEdge: 0, up: 'z' };

/** The parameters of one kind as rows of controls. */
export class Parameters {
  element = element('div.parameters');
  #all: Parameter[];
  #error = element('p.error', { hidden: true, 'aria-live': 'polite' });

  /**
   * @param values missing ones have their default
   * @param options `name`
   *   prefixes the accessible names of the controls
   */
  constructor(
    params: ParamInfo[],
    values: Record<string, ParamValue>,
    model: Model | null,
    {
      name = '',
      changed = () => {},
    }: { name?: string; changed?: (id: string, value: ParamValue) => void } = {},
  ) {
    this.#all = params.map((param) => {
      const value = param.id in values ? values[param.id] : param.default;
      const prefix = name ? `${name}: ` : '';
      return new Parameter(param, value, model ?? NO_MODEL, prefix, (next) => {
        this.#showError('');
        changed(param.id, next);
      });
    });
    this.element.replaceChildren(...this.#all.map((one) => one.element), this.#error);
    this.element.hidden = params.length === 0;
  }

  /** Returns the values, or null if a field is invalid. */
  values() {
    const values: Record<string, ParamValue> = {};
    for (const one of this.#all) {
      const value = one.read();
      if (value === undefined) return null;
      values[one.id] = value;
    }
    return values;
  }

  /**
   * Shows an error with a `path` in the scene at its parameter, or below all parameters if it
   * concerns several. Returns false if it concerns something else.
   */
  refuse(error: unknown) {
    if (!(error instanceof Error && 'path' in error)) return false;
    const at = String(error.path);
    const path = at.replace(/^constraints\[\d+\]\.?/, '');
    const message = error.message.replace(`${at}: `, '');
    const [, id = '', place = '0'] = /^([^.[]*)(?:\[(\d+)\])?/.exec(path) ?? [];
    const about = this.#all.find((one) => one.id === id);
    about?.refuse(message, Number(place));
    if (path === '') this.#showError(message);
    return about !== undefined || path === '';
  }

  /** @param message concerning all parameters */
  #showError(message: string) {
    this.#error.textContent = message;
    this.#error.hidden = message === '';
  }

  /** Restores these values after a refused change. */
  restore(values: Record<string, ParamValue>) {
    for (const one of this.#all) one.show(values[one.id]);
  }
}

/** The row of one parameter. */
class Parameter {
  element;
  #param;
  #value;
  #model;
  #name;
  #changed;
  #fields: HTMLInputElement[] = [];
  #place = element('span.fields');
  #forms = element('select');
  #error = element('p.error', { hidden: true, 'aria-live': 'polite' });

  constructor(
    param: ParamInfo,
    value: ParamValue,
    model: Model,
    prefix: string,
    changed: (value: ParamValue) => void,
  ) {
    this.#param = param;
    this.#value = value;
    this.#model = model;
    this.#name = `${prefix}${param.label}`;
    this.#changed = changed;
    this.#error.id = `error-${this.#name.replace(/\W+/g, '-')}`;
    this.#forms.setAttribute('aria-label', `${this.#name}: kind of value`);
    this.#forms.append(
      ...param.forms.map((form) => element('option', { value: keyOf(form) }, labelOf(form))),
    );
    this.#forms.addEventListener('change', () => {
      const form = param.forms[this.#forms.selectedIndex];
      this.show(converted(param, form, this.#value, model));
      changed(this.#value);
    });
    this.element = element(
      'div.parameter',
      { role: 'group', 'aria-label': this.#name },
      element('span.label', param.label),
      param.forms.length > 1 && this.#forms,
      this.#place,
      this.#error,
    );
    this.show(value);
  }

  get id() {
    return this.#param.id;
  }

  /** Shows a value and clears the error. */
  show(value: ParamValue) {
    this.#value = value;
    const key = keyOfValue(value);
    const numbers = Array.isArray(value) ? value : typeof value === 'number' ? [value] : [];
    const names = numbers.length > 0 ? FIELD_NAMES[key] : [];
    this.#forms.value = key;
    this.#fields = numbers.map((one, i) => this.#field(one, names[i], key));
    const unit = key === 'vector' ? '' : unitOf(this.#param, this.#model.units);
    this.#place.replaceChildren(
      ...(key === 'vector' ? [this.#axes()] : []),
      ...this.#fields.flatMap((field, i) => (key === 'range' && i === 1 ? ['–', field] : [field])),
      ...(unit && names.length > 0 ? [element('span.quiet', unit)] : []),
    );
    this.#place.className = `fields ${key.split(' ')[0]}`;
    this.#showError('');
  }

  /** @param key of the form */
  #field(value: number | null, name: string, key: string) {
    const [least, greatest] = this.#param.range;
    const isLength = key !== 'vector';
    const field = element('input', {
      type: 'number',
      step: 'any',
      ...(isLength ? { min: least } : {}),
      ...(isLength && Number.isFinite(greatest) ? { max: greatest } : {}),
      ...(key === 'range' ? { placeholder: 'no limit' } : { required: true }),
      value: value === null ? '' : String(value),
      'aria-label': this.#name + name,
      'aria-describedby': this.#error.id,
      // Validate on input: an error that appears on blur would move the page under the pointer that
      // leaves the field for a button.
      oninput: () => this.read(),
      onchange: () => {
        const next = this.read();
        if (next === undefined) return;
        this.#value = next;
        this.#changed(next);
      },
    });
    return field;
  }

  /** Makes the buttons for axis directions. */
  #axes() {
    const buttons = AXES.map((name) =>
      element(
        'button',
        {
          'aria-label': `${this.#name} along ${name.toUpperCase()}`,
          'aria-pressed': String(axis(name).every((part, i) => part === this.#vector()[i])),
          onclick: () => {
            this.show(axis(name));
            this.#changed(this.#value);
          },
        },
        name.toUpperCase(),
      ),
    );
    return element('span.segmented', ...buttons);
  }

  #vector() {
    return Array.isArray(this.#value) ? this.#value : [];
  }

  /** Returns the value of the fields. If one is invalid, shows the error and returns undefined. */
  read(): ParamValue | undefined {
    const wrong = this.#fields.find((field) => !field.validity.valid);
    if (wrong) {
      this.#showError(wrong.validationMessage, wrong);
      return undefined;
    }
    this.#showError('');
    if (this.#fields.length === 0) return this.#value;
    const numbers = this.#fields.map((field) => (field.value === '' ? null : field.valueAsNumber));
    return (numbers.length === 1 ? numbers[0] : numbers) as ParamValue;
  }

  /** @param place index of the invalid field */
  refuse(message: string, place: number) {
    this.#showError(message, this.#fields[place] ?? this.#fields[0]);
  }

  #showError(message: string, field?: HTMLInputElement) {
    for (const one of this.#fields) one.toggleAttribute('aria-invalid', false);
    field?.setAttribute('aria-invalid', 'true');
    this.#error.textContent = message;
    this.#error.hidden = message === '';
  }
}
