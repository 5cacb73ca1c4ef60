/** The axis of a legend: the positions of values, linear or logarithmic. */

/** The least start of a logarithmic axis, relative to its end. */
const LEAST_PART = 1e-6;
/** Round numbers for the ends of an axis, from 1 to 10. */
const ROUND = [1, 1.5, 2, 3, 4, 5, 6, 8, 10];

export interface Axis {
  /** the start; above 0 on a logarithmic axis */
  low: number;
  /** the end */
  high: number;
  log: boolean;
}

export function axisOf(low: number, high: number, log: boolean): Axis {
  return { low: log ? Math.max(low, LEAST_PART * high) : low, high, log };
}

/** Returns the position of a value from 0 to 1, clamped to the ends; NaN for NaN. */
export function positionOf({ low, high, log }: Axis, value: number) {
  if (!(high > low)) return 0;
  const part = log
    ? Math.log(Math.max(value, low) / low) / Math.log(high / low)
    : (value - low) / (high - low);
  return Math.min(Math.max(part, 0), 1);
}

/** Returns the value at a position from 0 to 1. */
export function valueAt({ low, high, log }: Axis, position: number) {
  return log ? low * (high / low) ** position : low + position * (high - low);
}

/** The most steps between the ticks of a logarithmic axis. */
const MOST_STEPS = 6;

/** Returns equally spaced exponents for the ticks of a logarithmic axis, ascending. */
export function tickExponents(first: number, last: number) {
  const stride = Math.max(1, Math.ceil((last - first) / MOST_STEPS));
  const exponents = [];
  for (let exponent = first; exponent <= last; exponent += stride) exponents.push(exponent);
  return exponents;
}

/** Returns the next round number, so that the end of an axis changes seldom. */
export function roundUp(value: number) {
  if (!(value > 0) || !Number.isFinite(value)) return 0;
  const power = 10 ** Math.floor(Math.log10(value));
  // The default covers a power that is rounded down.
  return (ROUND.find((round) => round * power >= value * (1 - 1e-9)) ?? 10) * power;
}
