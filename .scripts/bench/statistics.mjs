// Statistics of repeated measurements, for Node.js and for the browser.

export const sum = (values) => values.reduce((all, one) => all + one, 0);

/** The middle one of the values, or null if there are none. */
export const median = (values) =>
  values.length ? values.toSorted((a, b) => a - b)[values.length >> 1] : null;

/** Returns the median of measured times, the ends of their middle half, and how many they are. */
export function spread(times) {
  const [sorted, last] = [times.toSorted((a, b) => a - b), times.length - 1];
  const [low, high] = [sorted[Math.floor(last / 4)], sorted[Math.ceil((3 * last) / 4)]];
  return { median: median(times), low, high, runs: times.length };
}

/** Returns the spread of each property over objects of numbers. */
export function spreads(objects) {
  const keys = Object.keys(objects[0] ?? {});
  return Object.fromEntries(keys.map((key) => [key, spread(objects.map((one) => one[key]))]));
}

/** The most runs of one measurement, and the milliseconds after which there is no further one. */
const [MOST_RUNS, LONG_MS] = [5, 3000];

/** Measures several times, unless that takes long; returns the last result, with the spread of one time. */
export async function repeated(time, measure) {
  const [started, all] = [performance.now(), []];
  do all.push(await measure());
  while (all.length < MOST_RUNS && performance.now() - started < LONG_MS);
  return { ...all.at(-1), [time]: spread(all.map((one) => one[time])) };
}
