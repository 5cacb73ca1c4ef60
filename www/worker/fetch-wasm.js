/** The fetch of the solver's module, which tells how far it is where it takes a while. */

/** So long nobody waits for words, and so often they are renewed, in milliseconds. */
const LATE_MS = 500;
const EVERY_MS = 200;

/**
 * @param {(message: import("../solver/messages.js").FromWorker) => void} post
 * @returns {Promise<Response>} the module; rejects with the reason where it does not come
 */
export async function fetchModule(post) {
  const address = new URL('../pkg/solver/shape_up_bg.wasm', import.meta.url);
  const response = await fetch(address).catch(() => {
    throw new Error('its module could not be fetched');
  });
  if (!response.ok) throw new Error(`its module could not be fetched: ${response.status}`);
  // A copy is counted: browsers keep what they have compiled for an answer as it came only.
  count(response.clone(), post).catch(() => {});
  return response;
}

/**
 * @param {Response} response
 * @param {(message: import("../solver/messages.js").FromWorker) => void} post
 */
async function count({ body }, post) {
  const reader = body?.getReader();
  // Compressed as it travels, its length is not told: the build knows it.
  const all = import.meta.env.SOLVER_BYTES;
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
