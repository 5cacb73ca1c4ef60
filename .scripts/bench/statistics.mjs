// What is told of many measurements of one thing.

/** The value that a part `q` of the values is below. Null of none. */
export function quantile(values, q) {
  if (values.length === 0) return null;
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))];
}

export const median = (values) => quantile(values, 0.5);

/** The least, median, 10th and 90th percentile. */
export const spread = (values) => ({
  least: quantile(values, 0),
  median: median(values),
  p10: quantile(values, 0.1),
  p90: quantile(values, 0.9),
});

/** The medians of each property of some objects of numbers. */
export function medians(objects) {
  const keys = Object.keys(objects[0] ?? {});
  return Object.fromEntries(keys.map((key) => [key, median(objects.map((one) => one[key]))]));
}

/**
 * How a cost grows between two sizes: the exponent `p` of `n^p`, and the cost at the larger size
 * over what `n log n` would make of that at the smaller.
 */
export function growth([n, cost], [larger, costThere]) {
  const linearithmic = (larger * Math.log(larger)) / (n * Math.log(n));
  return {
    exponent: Math.log(costThere / cost) / Math.log(larger / n),
    overLinearithmic: costThere / cost / linearithmic,
  };
}

/**
 * The iterations and milliseconds until an energy is within parts of the converged one, null where
 * it was not reached. `energies` has one more than `steps`, the one before the first.
 */
export function reached({ energies, steps }, converged, parts) {
  return parts.map((part) => {
    const iterations = energies.findIndex((energy) => energy <= converged * (1 + part));
    if (iterations < 0) return null;
    return { iterations, ms: steps.slice(0, iterations).reduce((sum, ms) => sum + ms, 0) };
  });
}
