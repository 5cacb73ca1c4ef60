/** The page's side of the worker that makes parts. */

import type { BuildReplies, BuildRequest } from '../../solver/messages.ts';

type Waiting = { resolve: (value: unknown) => void; reject: (error: Error) => void };

export class BuildClient {
  #worker;
  #waiting: Map<number, Waiting> = new Map();
  #next = 0;

  constructor() {
    this.#worker = new Worker(new URL('./build-worker.ts', import.meta.url), {
      type: 'module',
      name: 'build',
    });
    this.#worker.onmessage = ({ data }) => {
      const waiting = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if ('refused' in data) waiting?.reject(new Error(data.refused));
      else waiting?.resolve(data.value);
    };
    this.#worker.onerror = (event) => {
      event.preventDefault();
      const error = new Error(
        'The sheet module could not be loaded. Check the network connection.',
      );
      for (const { reject } of this.#waiting.values()) reject(error);
      this.#waiting.clear();
    };
  }

  ask<Type extends keyof BuildReplies>(
    request: Extract<BuildRequest, { type: Type }>,
  ): Promise<BuildReplies[Type]> {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve: resolve as Waiting['resolve'], reject });
      this.#worker.postMessage({ id, request });
    });
  }
}
