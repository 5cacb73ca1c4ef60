// Statistics of repeated measurements, for Node.js and for the browser.

/** The middle one of the values, or null if there are none. */
export const median = (values) =>
  values.length ? values.toSorted((a, b) => a - b)[values.length >> 1] : null;

/** Returns the medians of each property over objects of numbers. */
export function medians(objects) {
  const keys = Object.keys(objects[0] ?? {});
  return Object.fromEntries(keys.map((key) => [key, median(objects.map((one) => one[key]))]));
}

/** Returns the number of iterations until the energies, of which one precedes them, reach a goal. */
export function iterationsUntil(goal, energies) {
  const reached = energies.findIndex((energy) => energy <= goal);
  return reached < 0 ? null : reached;
}
