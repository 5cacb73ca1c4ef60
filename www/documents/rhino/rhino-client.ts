/** Page side of the Rhino worker: one worker per file, terminated after the answer. */

import { Cancelled } from '../../solver/errors.ts';
import { calling, Waiting, type Remote } from '../../solver/remote.ts';
import type * as Converter from './rhino-converter.ts';

/**
 * @param ask calls a method of the worker
 * @returns rejects with the error in the file, or when cancelled
 */
export async function askRhino<Answer>(
  ask: (rhino: Remote<typeof Converter>) => Promise<Answer>,
  cancelled?: AbortSignal,
): Promise<Answer> {
  const worker = new Worker(new URL('./rhino-worker.ts', import.meta.url), {
    type: 'module',
    name: 'rhino',
  });
  const waiting = new Waiting();
  worker.onmessage = ({ data }) => waiting.receive(data);
  worker.onerror = (event) => {
    event.preventDefault();
    waiting.fail(() => new Error('The .3dm converter could not be loaded. Check the network.'));
  };
  cancelled?.addEventListener('abort', () => waiting.fail(() => new Cancelled()));
  try {
    return await ask(
      calling((name, given) => waiting.call(name, given, (call) => worker.postMessage(call))),
    );
  } finally {
    worker.terminate();
  }
}
