/** The forms of parameter values: keys, labels, conversion between forms, and values in words. */

import { brief, numberIn, rangeIn, rounded } from '../words.ts';
import type { Form, Param, ParamValue } from '../../pkg/engine/shape_up.js';

/** What the controls need to know of the coordinates, as they are now. */
export interface Frame {
  /** of lengths; empty when not known */
  units: string;
  /** default length; 0 when not known */
  meanEdge: number;
  up: 'y' | 'z';
}

export const AXES = ['x', 'y', 'z'];

/** Labels of the forms. */
const FORM_LABELS: Record<string, string> = {
  number: 'exactly',
  range: 'between',
  vector: 'direction',
  nothing: 'Best fit',
};

/** Suffixes of the accessible names of the fields of a form. */
export const FIELD_NAMES: Record<string, string[]> = {
  number: [''],
  range: [' from', ' to'],
  vector: AXES.map((axis) => ` ${axis}`),
};

/** Returns the key of a form: its name, or one made from its word. */
export function keyOf(form: Form) {
  return typeof form === 'string' ? form : `word ${form.word}`;
}

/** Returns the key of the form of a value. */
export function keyOfValue(value: ParamValue) {
  if (value === null) return 'nothing';
  if (typeof value === 'string') return `word ${value}`;
  if (typeof value === 'number') return 'number';
  return value.length === 2 ? 'range' : 'vector';
}

/** Returns the name of a word of a parameter. */
const wordLabel = ({ labels = [] }: Param, word: string) =>
  labels.find(([one]) => one === word)?.[1] ?? word;

/** Returns the label of a form of a parameter. */
export function labelOf(param: Param, form: Form) {
  return typeof form === 'string' ? FORM_LABELS[form] : wordLabel(param, form.word);
}

export function unitOf({ unit }: Param, units: string) {
  if (unit === 'degrees') return '°';
  if (!unit || !units) return '';
  return units + { length: '', area: '²', volume: '³' }[unit];
}

/** Digits of any number. */
const DIGITS = 15;

/** Rounds an initial number to two digits. */
const roundedUsual = (value: number) => rounded(value, 2);

function inRange({ range: [least, greatest] }: Param, value: number) {
  return Math.min(Math.max(value, least), greatest ?? Infinity);
}

/** Returns an initial number for a parameter without a numeric default. */
function usual(param: Param, { meanEdge }: Frame) {
  const edge = meanEdge || 1;
  const [least, greatest] = param.range;
  const middle = Number.isFinite(greatest) ? (least + greatest) / 2 : 90;
  const byUnit = { length: edge, area: edge ** 2, volume: edge ** 3, degrees: middle, '': 1 };
  return inRange(param, roundedUsual(byUnit[param.unit]));
}

/** Returns the middle of a range, with as few digits as leave it in the range, but at least two. */
function middleOf(low: number, high: number) {
  const middle = (low + high) / 2;
  let digits = 2;
  let value = rounded(middle, digits);
  while ((value < low || value > high) && digits < DIGITS) value = rounded(middle, ++digits);
  return value < low || value > high ? middle : value;
}

/** Converts a value to another form of the parameter. */
export function converted(param: Param, form: Form, before: ParamValue, frame: Frame): ParamValue {
  const [low, high] = Array.isArray(before) && before.length === 2 ? before : [null, null];
  switch (form) {
    case 'number':
      if (low !== null && high !== null) return middleOf(low, high);
      return (
        low ?? high ?? (typeof param.default === 'number' ? param.default : usual(param, frame))
      );
    case 'range': {
      if (keyOfValue(param.default) === 'range') return param.default;
      const middle = typeof before === 'number' ? before : usual(param, frame);
      const ends = middle === 0 ? [0, usual(param, frame)] : [0.9 * middle, 1.1 * middle];
      const [from, to] = ends.map((end) => inRange(param, rounded(end, 3)));
      return from < to ? [from, to] : [to, from];
    }
    case 'vector':
      return keyOfValue(param.default) === 'vector' ? param.default : axis(frame.up);
    case 'nothing':
      return null;
    default:
      return form.word;
  }
}

export function axis(name: string): [number, number, number] {
  return name === 'x' ? [1, 0, 0] : name === 'y' ? [0, 1, 0] : [0, 0, 1];
}

/** Formats a value with its unit. */
export function valueInWords(param: Param, value: ParamValue, units: string) {
  const unit = unitOf(param, units);
  if (value === null) return FORM_LABELS.nothing;
  if (typeof value === 'string') return wordLabel(param, value);
  if (typeof value === 'number') return numberIn(value, unit);
  if (value.length === 3) {
    const named = AXES.find((name) => axis(name).every((part, i) => part === value[i]));
    return named?.toUpperCase() ?? value.map((part) => brief(roundedUsual(part))).join(', ');
  }
  return rangeIn(...value, unit);
}
