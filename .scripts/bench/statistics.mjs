// Statistics of repeated measurements.

/** Returns the `q`-quantile of the values; null if there are none. */
export function quantile(values, q) {
  if (values.length === 0) return null;
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))];
}

export const median = (values) => quantile(values, 0.5);

/** Returns the minimum, the median, and the 10th and 90th percentile. */
export const spread = (values) => ({
  least: quantile(values, 0),
  median: median(values),
  p10: quantile(values, 0.1),
  p90: quantile(values, 0.9),
});

/** Returns the medians of each property over objects of numbers. */
export function medians(objects) {
  const keys = Object.keys(objects[0] ?? {});
  return Object.fromEntries(keys.map((key) => [key, median(objects.map((one) => one[key]))]));
}

/**
 * Growth of a cost between two sizes: the exponent `p` of `n^p`, and the cost at the larger size
 * divided by the extrapolation of the smaller by `n log n`.
 */
export function growth([n, cost], [larger, costThere]) {
  const linearithmic = (larger * Math.log(larger)) / (n * Math.log(n));
  return {
    exponent: Math.log(costThere / cost) / Math.log(larger / n),
    overLinearithmic: costThere / cost / linearithmic,
  };
}

/**
 * Returns the iterations and milliseconds until an energy is within relative distances `parts` of
 * the converged one; null if not reached. `energies` has one entry more than `steps`: the first.
 */
export function reached({ energies, steps }, converged, parts) {
  return parts.map((part) => {
    const iterations = energies.findIndex((energy) => energy <= converged * (1 + part));
    if (iterations < 0) return null;
    return { iterations, ms: steps.slice(0, iterations).reduce((sum, ms) => sum + ms, 0) };
  });
}

/** Whether a mesh counts as one of a size. Meshes are square grids: 173 by 173 counts as 30,000. */
export const isOfSize = (vertices, size) => Math.abs(vertices / size - 1) < 0.05;
