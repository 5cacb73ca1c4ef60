// Statistics of repeated measurements, for Node.js and for the browser.

export const sum = (values) => values.reduce((all, one) => all + one, 0);

/** The middle one of the values, or null if there are none. */
export const median = (values) =>
  values.length ? values.toSorted((a, b) => a - b)[values.length >> 1] : null;

/** Returns the medians of each property over objects of numbers. */
export function medians(objects) {
  const keys = Object.keys(objects[0] ?? {});
  return Object.fromEntries(keys.map((key) => [key, median(objects.map((one) => one[key]))]));
}
