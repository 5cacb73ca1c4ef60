/** What the arrow keys make of a number in a field. */

import { metresOf, rounded } from '../words.ts';

/** Significant digits of decimals, which sums of them keep. */
const DIGITS = 15;
/** A first length, in metres. */
const FIRST_LENGTH = 0.01;
/** A first number without a unit of length that is not whole. */
const FIRST = 0.1;
/** Below this part of a first number, a step towards 0 ends there. */
const LEAST = 0.01;

/** How a field is changed. */
export interface Steps {
  /** the symbol of its unit if that is one of length */
  unit?: string;
  /** of every number; absent where numbers of all sizes are usual */
  step?: number;
  /** whether only numbers above 0 are accepted */
  isPositive?: boolean;
}

/**
 * Returns the next number up (`by` = 1) or down (−1): one more or less in the second significant digit,
 * which suits every size and unit. Whole numbers without a unit change by one: they may be counts.
 */
export function nextNumber(value: number, by: 1 | -1, { unit = '', step, isPositive }: Steps) {
  const isTowardsZero = value * by < 0;
  const avoidsZero = isTowardsZero && isPositive;
  const isCount = unit === '' && Number.isInteger(value) && !(avoidsZero && value === 1);
  const isTiny = isTowardsZero && !avoidsZero && Math.abs(value) < LEAST * firstIn(unit);
  const change = step ?? (isCount ? 1 : isTiny ? Math.abs(value) : stepOf(value, by, unit));
  return rounded(value + by * change, DIGITS);
}

function stepOf(value: number, by: 1 | -1, unit: string) {
  if (value === 0) return firstIn(unit);
  const [digits, exponent] = Math.abs(value).toExponential().split('e');
  // 0.1 goes down to 0.099, from where it comes back to 0.1.
  const isLeast = digits === '1' && value * by < 0;
  return Number(`1e${Number(exponent) - (isLeast ? 2 : 1)}`);
}

/** The first number from 0, a power of ten; also a step for coordinates, whose size says nothing. */
export function firstIn(unit: string) {
  const metres = metresOf(unit);
  return metres === undefined ? FIRST : 10 ** Math.round(Math.log10(FIRST_LENGTH / metres));
}
