/** How the values of the faces are spread: what the legend shows of them. */

import { placeOn } from './value-axis.js';

/** Bars of the histogram. */
export const BINS = 36;

/**
 * @typedef {object} Spread
 * @property {import("../../solver/messages.js").Measure} measure
 * @property {number} greatest of either sign
 * @property {import("./value-axis.js").Axis} axis of the bars
 * @property {number[]} counts faces per bar, `#bins`
 * @property {number} faces that have a value
 * @property {number} within faces that are within the tolerance; all without one
 * @property {{ counts: number[], greatest: number } | null} original the same bars for the original shape, without
 *   faces beyond the end
 */

/**
 * @param {import("../../solver/messages.js").Measure} measure
 * @param {Float32Array} values not a number where a face has none
 * @param {import("./value-axis.js").Axis} axis
 * @param {number | null} tolerance
 * @param {Float32Array | null} [original] values of the original shape
 * @returns {Spread}
 */
export function spreadOf(measure, values, axis, tolerance, original = null) {
  // As the view compares them.
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
 * Faces per bar along an axis; the first and the last bar have what is at the ends, and what is below
 * the first. Not a number is in none, nor what is beyond the end.
 * @param {Float32Array} values
 * @param {import("./value-axis.js").Axis} axis
 * @returns {number[]}
 */
export function countsOf(values, axis) {
  const counts = new Array(BINS).fill(0);
  // What is as great as the end has been rounded.
  const end = Math.fround(axis.high) * (1 + 1e-6);
  for (const value of values) {
    if (value <= end) counts[Math.min(BINS - 1, Math.floor(placeOn(axis, value) * BINS))] += 1;
  }
  return counts;
}

/** The greatest size of values, some of which may be no numbers. @param {Float32Array} values */
export function greatestOf(values) {
  return values.reduce((most, value) => (Math.abs(value) > most ? Math.abs(value) : most), 0);
}
