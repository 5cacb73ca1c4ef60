/** Distribution of the values of the faces, for the legend. */

import { positionOf } from './value-axis.js';

/** The number of bars of the histogram. */
export const BINS = 36;

/**
 * @typedef {object} Spread
 * @property {import("../../solver/messages.js").Measure} measure
 * @property {number} greatest absolute value
 * @property {import("./value-axis.js").Axis} axis of the bars
 * @property {number[]} counts faces per bar, `#bins`
 * @property {number} faces number of faces with a value
 * @property {number} within number of faces within the tolerance; all without one
 * @property {{ counts: number[], greatest: number } | null} original the same bars for the original
 *   shape, without faces beyond the end
 */

/**
 * @param {import("../../solver/messages.js").Measure} measure
 * @param {Float32Array} values NaN for faces without one
 * @param {import("./value-axis.js").Axis} axis
 * @param {number | null} tolerance
 * @param {Float32Array | null} [original] values of the original shape
 * @returns {Spread}
 */
export function spreadOf(measure, values, axis, tolerance, original = null) {
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
 * @param {Float32Array} values
 * @param {import("./value-axis.js").Axis} axis
 * @returns {number[]}
 */
export function countsOf(values, axis) {
  const counts = new Array(BINS).fill(0);
  // Values equal to the end may have been rounded up.
  const end = Math.fround(axis.high) * (1 + 1e-6);
  for (const value of values) {
    if (value <= end) counts[Math.min(BINS - 1, Math.floor(positionOf(axis, value) * BINS))] += 1;
  }
  return counts;
}

/** Returns the greatest absolute value, ignoring NaN. @param {Float32Array} values */
export function greatestOf(values) {
  return values.reduce((most, value) => (Math.abs(value) > most ? Math.abs(value) : most), 0);
}
