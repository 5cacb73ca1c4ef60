/** Page side of the Rhino worker: one worker per file, terminated after the answer. */

/** @typedef {import("../../solver/messages.js").RhinoReplies} RhinoReplies */

/**
 * @template {keyof RhinoReplies} Type
 * @param {Extract<import("../../solver/messages.js").RhinoRequest, { type: Type }>} request
 * @param {AbortSignal} [cancelled]
 * @returns {Promise<RhinoReplies[Type]>} rejects with the error in the file, or when cancelled
 */
export async function askRhino(request, cancelled) {
  const worker = new Worker(new URL('./rhino-worker.js', import.meta.url), {
    type: 'module',
    name: 'rhino',
  });
  try {
    return await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) =>
        'refused' in data ? reject(new Error(data.refused)) : resolve(data.value);
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error('The .3dm converter could not be loaded. Check the network.'));
      };
      cancelled?.addEventListener('abort', () => reject(new Error('Cancelled.')));
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}
