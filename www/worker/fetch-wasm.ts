/** Fetches and compiles the engine, and reports progress if that takes long. */

import type { FromWorker } from '../solver/events.ts';

/** Delay of the first progress report and interval of the next ones, in milliseconds. */
const LATE_MS = 500;
const EVERY_MS = 200;

/** @returns the compiled module; rejects with the reason if it cannot be fetched */
export async function fetchModule(post: (message: FromWorker) => void) {
  const address = new URL('../pkg/engine/shape_up_bg.wasm', import.meta.url);
  const response = await fetch(address).catch(() => {
    throw new Error('its module could not be fetched');
  });
  if (!response.ok) throw new Error(`its module could not be fetched: ${response.status}`);
  // Count on a copy: browsers cache compiled code only for an unmodified response.
  count(response.clone(), post).catch(() => {});
  // Compiling while bytes arrive needs the right type, which not every host sends.
  return response.headers.get('content-type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

async function count({ body }: Response, post: (message: FromWorker) => void) {
  const reader = body?.getReader();
  // A compressed response has no usable length; the build supplies it.
  const all = import.meta.env.ENGINE_BYTES;
  let due = performance.now() + LATE_MS;
  for (let bytes = 0; reader;) {
    const { done, value } = await reader.read();
    if (done) return;
    bytes += value.length;
    if (performance.now() < due) continue;
    due = performance.now() + EVERY_MS;
    post({ type: 'loading', bytes, all });
  }
}
