/** The page's side of the worker that makes parts. */

/** @typedef {import("../../solver/messages.js").BuildRequest} BuildRequest */
/** @typedef {import("../../solver/messages.js").BuildReplies} BuildReplies */
/** @typedef {{ resolve: (value: any) => void, reject: (error: Error) => void }} Waiting */

export class BuildClient {
  #worker;
  /** @type {Map<number, Waiting>} */
  #waiting = new Map();
  #next = 0;

  constructor() {
    this.#worker = new Worker(new URL('./build-worker.js', import.meta.url), {
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

  /**
   * @template {keyof BuildReplies} Type
   * @param {Extract<BuildRequest, { type: Type }>} request
   * @returns {Promise<BuildReplies[Type]>}
   */
  ask(request) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#worker.postMessage({ id, request });
    });
  }
}
