/** The page's side of the worker that makes parts. */

import { calling, Waiting, type Remote } from '../../solver/remote.ts';
import type { BuildMethods } from './build-worker.ts';

/** Starts the worker, and returns its methods. */
export function startBuilder(): Remote<BuildMethods> {
  const worker = new Worker(new URL('./build-worker.ts', import.meta.url), {
    type: 'module',
    name: 'build',
  });
  const waiting = new Waiting();
  worker.onmessage = ({ data }) => {
    const error = 'refused' in data ? new Error(data.refused) : null;
    waiting.settle(data.id, data.value, error);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    waiting.fail(new Error('The sheet module could not be loaded. Check the network connection.'));
  };
  return calling((name, given) => waiting.call(name, given, (call) => worker.postMessage(call)));
}
