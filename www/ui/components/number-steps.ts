/** What the arrow keys make of a number in a field. */

import { metresOf, rounded } from '../words.ts';

/** Significant digits of decimals, which sums of them keep. */
const DIGITS = 15;
/** A first length, in metres. */
const FIRST_LENGTH = 0.01;
/** A first number without a unit of length. */
const FIRST = 0.1;

/** How a field is changed. */
export interface Steps {
  /** the symbol of its unit if that is one of length */
  unit?: string;
  /** of every number; absent where numbers of all sizes are usual */
  step?: number;
}

/**
 * Returns the next number up (`by` = 1) or down (−1): one more or less in the second significant digit,
 * which suits every size and unit.
 */
export function nextNumber(value: number, by: 1 | -1, { unit = '', step }: Steps) {
  return rounded(value + by * (step ?? stepOf(value, by, unit)), DIGITS);
}

function stepOf(value: number, by: 1 | -1, unit: string) {
  if (value === 0) return firstIn(unit);
  const [digits, exponent] = Math.abs(value).toExponential().split('e');
  // 0.1 goes down to 0.099, from where it comes back to 0.1.
  const isLeast = digits === '1' && value * by < 0;
  return Number(`1e${Number(exponent) - (isLeast ? 2 : 1)}`);
}

/** A power of ten. */
function firstIn(unit: string) {
  const metres = metresOf(unit);
  return metres === undefined ? FIRST : 10 ** Math.round(Math.log10(FIRST_LENGTH / metres));
}
