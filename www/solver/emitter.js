/** Events whose names and values are typed: a name that is misspelt is an error of types. */

/** @template {object} Events the value that each event comes with, by its name */
export class Emitter {
  /** @type {{ [T in keyof Events]?: Set<(value: Events[T]) => void> }} */
  #listeners = {};

  /**
   * @template {keyof Events} T
   * @param {T} type
   * @param {(value: Events[T]) => void} listener
   * @returns {() => void} ends it
   */
  on(type, listener) {
    const listeners = (this.#listeners[type] ??= new Set());
    listeners.add(listener);
    return () => listeners.delete(listener);
  }

  /**
   * The next time only.
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
   * Calls those that listen now. One that throws is no harm to the others.
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
