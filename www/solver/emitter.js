/** Events with typed names and values: a misspelt name is a type error. */

/** @template {object} Events maps the name of each event to the type of its value */
export class Emitter {
  /** @type {{ [T in keyof Events]?: Set<(value: Events[T]) => void> }} */
  #listeners = {};

  /**
   * @template {keyof Events} T
   * @param {T} type
   * @param {(value: Events[T]) => void} listener
   * @returns {() => void} removes the listener
   */
  on(type, listener) {
    const listeners = (this.#listeners[type] ??= new Set());
    listeners.add(listener);
    return () => listeners.delete(listener);
  }

  /**
   * Adds a listener for the next event only.
   * @template {keyof Events} T
   * @param {T} type
   * @param {(value: Events[T]) => void} listener
   */
  once(type, listener) {
    const end = this.on(type, (value) => {
      end();
      listener(value);
    });
  }

  /**
   * Calls the current listeners. An exception in one does not affect the others.
   * @template {keyof Events} T
   * @param {T} type
   * @param {Events[T]} value
   */
  emit(type, value) {
    for (const listener of [...(this.#listeners[type] ?? [])]) {
      try {
        listener(value);
      } catch (error) {
        reportError(error);
      }
    }
  }
}
