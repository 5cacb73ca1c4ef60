/** Parsing of typed lengths: 1.5, 1/3, 20cm; and relative ones, +0.5 or +-0.5. */

import { METRES } from './format.ts';

const DIGITS = '(?:\\d+[.,]?\\d*|[.,]\\d+)';
/** Sign of a relative entry, number, divisor, unit. */
const ENTRY = new RegExp(`^(\\+?)\\s*(-?${DIGITS})(?:\\s*/\\s*(${DIGITS}))?\\s*([a-z]*)$`, 'i');

/**
 * @param units of the model; empty when not known
 * @returns `by`: relative to the current value
 * @throws if it is no length; the message says what is expected
 */
export function readLength(text: string, units: string): { by: boolean; length: number } {
  const [, sign, number = '', divisor = '1', unit = ''] = ENTRY.exec(text.trim()) ?? [];
  const factor = unit === '' ? 1 : METRES[unit.toLowerCase()] / METRES[units];
  const length = (valueOf(number) / valueOf(divisor)) * factor;
  if (number === '' || !Number.isFinite(length)) {
    throw new Error(`“${text}” is not a length. Expected 1.5, 1/3 or +0.5.`);
  }
  return { by: sign === '+', length };
}

const valueOf = (digits: string) => Number(digits.replace(',', '.'));

/** Resolution of coordinates relative to the model: millimetres for a building of some 100 m. */
const STEPS = 2e5;
const MOST_DECIMALS = 12;

/**
 * Returns the number of decimals for coordinates.
 * @param size of the model, in its unit
 */
export function decimalsFor(size: number) {
  if (!(size > 0)) return 3;
  return Math.min(Math.max(Math.floor(Math.log10(STEPS / size)), 0), MOST_DECIMALS);
}

/** Formats a coordinate, without negative zero. */
export function coordinate(value: number, decimals: number) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text;
}
