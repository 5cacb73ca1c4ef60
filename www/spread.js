/** How the values of the faces are spread: what the legend shows of them. */

/** Bars of the histogram. */
export const BINS = 36;

/**
 * @typedef {object} Spread
 * @property {import("./messages.js").Measure} measure
 * @property {number} greatest
 * @property {number} top where the last bar ends; the first begins at 0
 * @property {number[]} counts faces per bar, `#bins`
 * @property {number} faces that have a value
 * @property {number} within faces that are within the tolerance; all without one
 * @property {{ counts: number[], greatest: number } | null} original the same bars for the original shape, without
 *   faces beyond the top
 */

/**
 * @param {import("./messages.js").Measure} measure
 * @param {Float32Array} values not a number where a face has none
 * @param {number} least the smallest top
 * @param {number} top of the range of the colours; the bars end there or beyond
 * @param {number | null} tolerance
 * @param {Float32Array | null} [original] values of the original shape
 * @returns {Spread}
 */
export function spreadOf(measure, values, least, top, tolerance, original = null) {
  const limit = tolerance ?? Infinity;
  let [greatest, faces, within] = [0, 0, 0];
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    faces += 1;
    if (value <= limit) within += 1;
    if (value > greatest) greatest = value;
  }
  const end = Math.max(greatest, top, least);
  return {
    measure,
    greatest,
    top: end,
    counts: countsOf(values, end),
    faces,
    within,
    original: original && { counts: countsOf(original, end), greatest: greatestOf(original) },
  };
}

/**
 * Faces per bar between 0 and `top`, which has its bar; not a number is in none, nor what is beyond.
 * @param {Float32Array} values
 * @param {number} top
 * @returns {number[]}
 */
export function countsOf(values, top) {
  const counts = new Array(BINS).fill(0);
  for (const value of values) {
    if (value <= top) counts[Math.min(BINS - 1, Math.floor((value / top) * BINS))] += 1;
  }
  return counts;
}

/** @param {Float32Array} values some of which may be no numbers */
export function greatestOf(values) {
  return values.reduce((greatest, value) => (value > greatest ? value : greatest), 0);
}
