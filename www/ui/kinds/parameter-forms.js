/** The forms of parameter values: keys, labels, conversion between forms, and values in words. */

import { number } from '../format.js';

/** @typedef {import("../../solver/messages.js").ParamInfo} ParamInfo */
/** @typedef {import("../../solver/messages.js").ParamValue} ParamValue */
/** @typedef {import("../../solver/messages.js").Form} Form */

/**
 * The part of the model that the controls use.
 * @typedef {object} Model
 * @property {string} units of lengths; empty when not known
 * @property {number} meanEdge default length
 * @property {"y" | "z"} up
 */

export const AXES = ['x', 'y', 'z'];

/** Labels of the forms. @type {Record<string, string>} */
const FORM_LABELS = {
  number: 'exactly',
  range: 'between',
  vector: 'direction',
  nothing: 'Best fit',
};

/** Suffixes of the accessible names of the fields of a form. @type {Record<string, string[]>} */
export const FIELD_NAMES = {
  number: [''],
  range: [' from', ' to'],
  vector: AXES.map((axis) => ` ${axis}`),
};

/** Returns the key of a form: its name, or one made from its word. @param {Form} form */
export function keyOf(form) {
  return typeof form === 'string' ? form : `word ${form.word}`;
}

/** Returns the key of the form of a value. @param {ParamValue} value */
export function keyOfValue(value) {
  if (value === null) return 'nothing';
  if (typeof value === 'string') return `word ${value}`;
  if (typeof value === 'number') return 'number';
  return value.length === 2 ? 'range' : 'vector';
}

/** @param {Form} form */
export function labelOf(form) {
  return typeof form === 'string' ? FORM_LABELS[form] : form.word;
}

/**
 * @param {ParamInfo} param
 * @param {string} units
 */
export function unitOf({ unit }, units) {
  if (unit === 'degrees') return '°';
  if (!unit || !units) return '';
  return units + { length: '', area: '²', volume: '³' }[unit];
}

/** Rounds an initial number to two digits. @param {number} value */
const rounded = (value) => Number(value.toPrecision(2));

/** @param {ParamInfo} param @param {number} value */
function inRange({ range: [least, greatest] }, value) {
  return Math.min(Math.max(value, least), greatest ?? Infinity);
}

/**
 * Returns an initial number for a parameter without a numeric default.
 * @param {ParamInfo} param
 * @param {Model} model
 */
function usual(param, { meanEdge }) {
  const edge = meanEdge || 1;
  const [least, greatest] = param.range;
  const middle = Number.isFinite(greatest) ? (least + greatest) / 2 : 90;
  const byUnit = { length: edge, area: edge ** 2, volume: edge ** 3, degrees: middle, '': 1 };
  return inRange(param, rounded(byUnit[param.unit]));
}

/**
 * Converts a value to another form of the parameter.
 * @param {ParamInfo} param
 * @param {Form} form
 * @param {ParamValue} before
 * @param {Model} model
 * @returns {ParamValue}
 */
export function converted(param, form, before, model) {
  const [low, high] = Array.isArray(before) && before.length === 2 ? before : [null, null];
  switch (form) {
    case 'number':
      if (low !== null && high !== null) return rounded((low + high) / 2);
      return (
        low ?? high ?? (typeof param.default === 'number' ? param.default : usual(param, model))
      );
    case 'range': {
      if (keyOfValue(param.default) === 'range') return param.default;
      const middle = typeof before === 'number' ? before : usual(param, model);
      const ends = middle === 0 ? [0, usual(param, model)] : [0.9 * middle, 1.1 * middle];
      const [from, to] = ends.map((end) => inRange(param, Number(end.toPrecision(3))));
      return from < to ? [from, to] : [to, from];
    }
    case 'vector':
      return keyOfValue(param.default) === 'vector' ? param.default : axis(model.up);
    case 'nothing':
      return null;
    default:
      return form.word;
  }
}

/** @param {string} name @returns {[number, number, number]} */
export function axis(name) {
  return name === 'x' ? [1, 0, 0] : name === 'y' ? [0, 1, 0] : [0, 0, 1];
}

/**
 * Formats a value with its unit.
 * @param {ParamInfo} param
 * @param {ParamValue} value
 * @param {string} units
 */
export function valueInWords(param, value, units) {
  const unit = unitOf(param, units);
  const amount = (/** @type {number} */ one) =>
    unit === '°' ? `${number(one)}°` : `${number(one)} ${unit}`.trim();
  if (value === null) return FORM_LABELS.nothing;
  if (typeof value === 'string') return value;
  if (typeof value === 'number') return amount(value);
  if (value.length === 3) {
    const named = AXES.find((name) => axis(name).every((part, i) => part === value[i]));
    return named?.toUpperCase() ?? value.map((part) => Number(part.toPrecision(2))).join(', ');
  }
  const [from, to] = value;
  if (from === null && to === null) return 'any';
  if (from === null) return `up to ${amount(/** @type {number} */ (to))}`;
  if (to === null) return `from ${amount(from)}`;
  return `${number(from)} to ${amount(to)}`;
}
