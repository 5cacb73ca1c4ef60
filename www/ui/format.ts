/**
 * Formatting of the numbers that are shown while a shape moves, and reading of typed lengths. Finished sentences come from the
 * engine, whose room `src/words` writes numbers in the same way: both read `tests/data/words.json`.
 */

import { UNITS } from './units.ts';

/** The length of each unit in metres. */
export const METRES: Record<string, number> = Object.fromEntries(
  UNITS.map(({ symbol, metres }) => [symbol, metres]),
);

const DIGITS = 3;

/** Formats a number with three significant digits; powers of ten below 1e-3 and from 1e6 on. */
export function number(value: number): string {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6)
    return value
      .toExponential(DIGITS - 1)
      .replaceAll('-', '−')
      .replace('e+', 'e');
  // Three digits would round the numbers just below to 1000, with a power of ten.
  const text = size >= 999.5 ? String(Math.round(value)) : value.toPrecision(DIGITS);
  return text.replace('-', '−');
}

/**
 * Returns a readable unit for a length of this size, and the factor to it. Metres become
 * millimetres below a decimetre; other units stay as they are.
 * @param units of the mesh; empty when not known
 */
export function lengthUnit(size: number, units: string): { unit: string; factor: number } {
  if (units === 'm' && Math.abs(size) < 0.1) return { unit: 'mm', factor: METRES.m / METRES.mm };
  return { unit: units, factor: 1 };
}

/** Lengths below this many millimetres are 0: they are irrelevant for buildings. */
const LEAST_MM = 0.001;
/** Millimetres in the units in which that is known. */
const MILLIMETRES: Record<string, number> = { mm: 1, m: 1000 };

/**
 * Formats a length with its unit. What would be a power of ten in metres is in millimetres.
 * @param value in units of the mesh
 * @param like the length that determines the unit: errors use that of their tolerance
 */
export function length(value: number, units: string, like: number = value): string {
  const { unit, factor } = lengthUnit(like, units);
  const size = Math.abs(value) * MILLIMETRES[units];
  if (size < LEAST_MM) return `0 ${unit}`;
  if (size < 1) return `${value < 0 ? '−' : ''}${size.toFixed(3)} mm`;
  return `${number(value * factor)} ${unit}`.trim();
}

/**
 * Formats a length entered by the user, such as a tolerance, without trailing zeros.
 * @param value in units of the mesh
 */
export function limit(value: number, units: string) {
  const { unit, factor } = lengthUnit(value, units);
  return `${round(value * factor).replace('-', '−')} ${unit}`.trim();
}

/** Formats a number as briefly as possible, with at most six significant digits. */
export function round(value: number) {
  const rounded = Number(value.toPrecision(6));
  const isTiny = rounded !== 0 && Math.abs(rounded) < 1e-3;
  return isTiny ? rounded.toExponential().replace('-', '−') : String(rounded);
}

/**
 * Formats a fraction in per cent.
 * @param share from 0 to 1
 */
export function part(share: number) {
  const percent = 100 * share;
  return percent > 0 && percent < 1 ? '< 1 %' : `${Math.round(percent)} %`;
}

export function duration(milliseconds: number): string {
  return `${milliseconds >= 99.5 ? Math.round(milliseconds) : milliseconds.toPrecision(2)} ms`;
}

/** Formats a ratio that is ideally near one. */
export function ratio(value: number): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? '–' : '∞';
  return value < 100 ? value.toFixed(4) : number(value);
}

/** Formats a count with its noun: "1 face", "12 faces". */
export function count(value: number, noun: string, plural: string = `${noun}s`): string {
  return `${groupDigits(value)} ${value === 1 ? noun : plural}`;
}

/** Formats a whole number with thin spaces between thousands, from five digits on. */
export function groupDigits(value: number): string {
  const digits = String(value);
  return digits.length < 5 ? digits : digits.replace(/\B(?=(\d{3})+$)/g, '\u2009');
}

/** Digits as they are typed. */
const TYPED = '(?:\\d+[.,]?\\d*|[.,]\\d+)';
/** Sign of a relative entry, number, divisor, unit. */
const ENTRY = new RegExp(`^(\\+?)\\s*(-?${TYPED})(?:\\s*/\\s*(${TYPED}))?\\s*([a-z]*)$`, 'i');

/**
 * Reads a typed length: 1.5, 1/3, 20cm; or a relative one, +0.5 or +-0.5.
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
