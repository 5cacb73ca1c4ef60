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
 */

/**
 * @param {import("./messages.js").Measure} measure
 * @param {Float32Array} values not a number where a face has none
 * @param {number} least the smallest top
 * @param {number} top of the range of the colours; the bars end there or beyond
 * @param {number | null} tolerance
 * @returns {Spread}
 */
export function spreadOf(measure, values, least, top, tolerance) {
  const limit = tolerance ?? Infinity;
  let [greatest, faces, within] = [0, 0, 0];
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    faces += 1;
    if (value <= limit) within += 1;
    if (value > greatest) greatest = value;
  }
  const end = Math.max(greatest, top, least);
  const counts = new Array(BINS).fill(0);
  for (const value of values) {
    if (!Number.isNaN(value)) counts[Math.min(BINS - 1, Math.floor((value / end) * BINS))] += 1;
  }
  return { measure, greatest, top: end, counts, faces, within };
}
