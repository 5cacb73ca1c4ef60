/** The page's end of the worker for files of Rhino: one worker for each file, and gone after it. */

/** @typedef {import("../../solver/messages.js").RhinoReplies} RhinoReplies */

/**
 * @template {keyof RhinoReplies} Type
 * @param {Extract<import("../../solver/messages.js").RhinoRequest, { type: Type }>} request
 * @param {AbortSignal} [cancelled]
 * @returns {Promise<RhinoReplies[Type]>} rejects with what is wrong with the file, or when it is cancelled
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
        reject(new Error('The part for .3dm files could not be fetched. Check the network.'));
      };
      cancelled?.addEventListener('abort', () => reject(new Error('It was cancelled.')));
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}
