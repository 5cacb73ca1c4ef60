/** Distribution of the values of the faces, for the legend. */

import { positionOf, type Axis } from './value-axis.ts';
import type { Measure } from '../../solver/types.ts';

/** The number of bars of the histogram. */
export const BINS = 36;

export interface Spread {
  measure: Measure;
  /** absolute value */
  greatest: number;
  /** of the bars */
  axis: Axis;
  /** faces per bar, `#bins` */
  counts: number[];
  /** number of faces with a value */
  faces: number;
  /** number of faces within the tolerance; all without one */
  within: number;
  /** the same bars for the original shape, without faces beyond the end */
  original: { counts: number[]; greatest: number } | null;
}

/**
 * @param values NaN for faces without one
 * @param original values of the original shape
 */
export function spreadOf(
  measure: Measure,
  values: Float32Array,
  axis: Axis,
  tolerance: number | null,
  original: Float32Array | null = null,
): Spread {
  // Rounded to f32, as in the view.
  const limit = tolerance === null ? Infinity : Math.fround(tolerance);
  let [greatest, faces, within] = [0, 0, 0];
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    faces += 1;
    if (value <= limit) within += 1;
    greatest = Math.max(greatest, Math.abs(value));
  }
  return {
    measure,
    greatest,
    axis,
    counts: countsOf(values, axis),
    faces,
    within,
    original: original && { counts: countsOf(original, axis), greatest: greatestOf(original) },
  };
}

/**
 * Counts faces per bar along an axis. The first and the last bar include the ends, and the first
 * also smaller values. NaN and values beyond the end are not counted.
 */
export function countsOf(values: Float32Array, axis: Axis): number[] {
  const counts = new Array(BINS).fill(0);
  // Values equal to the end may have been rounded up.
  const end = Math.fround(axis.high) * (1 + 1e-6);
  for (const value of values) {
    if (value <= end) counts[Math.min(BINS - 1, Math.floor(positionOf(axis, value) * BINS))] += 1;
  }
  return counts;
}

/** Returns the greatest absolute value, ignoring NaN. */
export function greatestOf(values: Float32Array) {
  return values.reduce((most, value) => (Math.abs(value) > most ? Math.abs(value) : most), 0);
}
