/** The axis of a legend: where values are along it, evenly or by their logarithm. */

/** So far below its end does a logarithmic axis begin at the latest. */
const LEAST_PART = 1e-6;
/** Round ends of an axis, from 1 to 10. */
const ROUND = [1, 1.5, 2, 3, 4, 5, 6, 8, 10];

/**
 * @typedef {object} Axis
 * @property {number} low where it begins; above 0 on a logarithmic one
 * @property {number} high where it ends
 * @property {boolean} log
 */

/**
 * @param {number} low
 * @param {number} high
 * @param {boolean} log
 * @returns {Axis}
 */
export function axisOf(low, high, log) {
  return { low: log ? Math.max(low, LEAST_PART * high) : low, high, log };
}

/**
 * Where a value is, from 0 to 1; beyond the ends it is at them, and not a number stays none.
 * @param {Axis} axis
 * @param {number} value
 */
export function placeOn({ low, high, log }, value) {
  if (!(high > low)) return 0;
  const part = log
    ? Math.log(Math.max(value, low) / low) / Math.log(high / low)
    : (value - low) / (high - low);
  return Math.min(Math.max(part, 0), 1);
}

/**
 * The value at a place from 0 to 1.
 * @param {Axis} axis
 * @param {number} place
 */
export function valueAt({ low, high, log }, place) {
  return log ? low * (high / low) ** place : low + place * (high - low);
}

/**
 * The next round number that is not smaller, so that the end of an axis changes seldom.
 * @param {number} value
 */
export function roundUp(value) {
  if (!(value > 0) || !Number.isFinite(value)) return 0;
  const power = 10 ** Math.floor(Math.log10(value));
  // A little more than 10 where the power is a little less.
  return (ROUND.find((round) => round * power >= value * (1 - 1e-9)) ?? 10) * power;
}
