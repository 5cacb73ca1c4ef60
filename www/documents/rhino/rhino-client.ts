/** Page side of the Rhino worker: one worker per file, terminated after the answer. */

import type { RhinoReplies, RhinoRequest } from './rhino-worker.ts';

/** @returns rejects with the error in the file, or when cancelled */
export async function askRhino<Type extends keyof RhinoReplies>(
  request: Extract<RhinoRequest, { type: Type }>,
  cancelled?: AbortSignal,
): Promise<RhinoReplies[Type]> {
  const worker = new Worker(new URL('./rhino-worker.ts', import.meta.url), {
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
