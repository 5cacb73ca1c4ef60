// Whether the machine is quiet: others neither compute nor take the core on which we do.

import { cpus } from 'node:os';
import { setTimeout as wait } from 'node:timers/promises';
import { sum } from './statistics.mjs';

/** The most that counts as quiet: busy cores beside us, and the part of the time without our core. */
const MOST = { busy: 0.25, stalled: 0.02 };
/** A loop that reads the clock never takes so many milliseconds by itself. */
const GAP_MS = 0.2;

/** Returns the milliseconds that all cores have been idle so far. */
const idle = () => sum(cpus().map(({ times }) => times.idle));

/** Returns the number of cores that others use while we wait. */
async function busyCores(moment) {
  const [start, before] = [performance.now(), idle()];
  await wait(moment);
  return Math.max(0, cpus().length - (idle() - before) / (performance.now() - start));
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
export async function otherLoad(moment) {
  return { busy: await busyCores(moment), stalled: stalled(moment) };
}

export const isQuiet = ({ busy, stalled }) => busy <= MOST.busy && stalled <= MOST.stalled;

/** Describes the measured load by others in some moments. */
export function otherLoadText(...moments) {
  const words = moments.every(isQuiet) ? 'It was quiet' : 'It was **not quiet**';
  const cores = moments.map(({ busy }) => busy.toFixed(1)).join(' and ');
  const lost = moments.map(({ stalled }) => `${(100 * stalled).toFixed(1)} %`).join(' and ');
  const when = moments.length > 1 ? ' before and after' : '';
  return `${words}: others used ${cores} cores, and ours was lost for ${lost} of the time${when}.`;
}
