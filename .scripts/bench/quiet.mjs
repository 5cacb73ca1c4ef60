// Whether the machine is quiet: others neither compute nor take the core on which we do.

import { cpus } from 'node:os';

/** The most that counts as quiet: busy cores beside us, and the part of a second without our core. */
const MOST_BUSY = 0.25;
const MOST_STALLED = 0.02;
/** A loop that reads the clock never takes so many milliseconds by itself. */
const GAP_MS = 0.2;

function idleAndAll() {
  const times = cpus().map(({ times }) => times);
  const all = times.map((one) => Object.values(one).reduce((sum, ms) => sum + ms, 0));
  return [times.map(({ idle }) => idle), all].map((list) => list.reduce((sum, ms) => sum + ms, 0));
}

/** Returns the number of cores that others use while we wait. */
async function busyCores(moment) {
  const [idle, all] = idleAndAll();
  await new Promise((done) => setTimeout(done, moment));
  const [idleThen, allThen] = idleAndAll();
  return cpus().length * (1 - (idleThen - idle) / Math.max(1, allThen - all));
}

/** Returns the part of a moment in which we compute without pause, but do not get the core. */
function stalled(moment) {
  const start = performance.now();
  let [last, lost] = [start, 0];
  while (last < start + moment) {
    const now = performance.now();
    if (now - last > GAP_MS) lost += now - last;
    last = now;
  }
  return lost / (last - start);
}

/** Measures for two moments, in milliseconds: { busy, stalled }. */
export async function unrest(moment) {
  return { busy: await busyCores(moment), stalled: stalled(moment) };
}

export const isQuiet = ({ busy, stalled }) => busy <= MOST_BUSY && stalled <= MOST_STALLED;

/** Describes the measured unrest before and after something. */
export function unrestText(before, after) {
  const words = isQuiet(before) && isQuiet(after) ? 'It was quiet' : 'It was **not quiet**';
  const both = (of) => [before, after].map(of).join(' and ');
  const cores = both(({ busy }) => Math.max(0, busy).toFixed(1));
  const lost = both(({ stalled }) => `${(100 * stalled).toFixed(1)} %`);
  return `${words}: others used ${cores} cores before and after, and our core was lost for ${lost} of the time.`;
}
