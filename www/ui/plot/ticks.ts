/** The ticks of logarithmic axes. */

/** The most steps between the ticks of a logarithmic axis. */
const MOST_STEPS = 6;

/** Returns equally spaced exponents for the ticks of a logarithmic axis, ascending. */
export function tickExponents(first: number, last: number) {
  const stride = Math.max(1, Math.ceil((last - first) / MOST_STEPS));
  const exponents = [];
  for (let exponent = first; exponent <= last; exponent += stride) exponents.push(exponent);
  return exponents;
}
