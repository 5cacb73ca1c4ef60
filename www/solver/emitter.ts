/** Events with typed names and values: a misspelt name is a type error. */

/** `Events` maps the name of each event to the type of its value */
export class Emitter<Events extends object> {
  #listeners: { [T in keyof Events]?: Set<(value: Events[T]) => void> } = {};

  /** @returns removes the listener */
  on<T extends keyof Events>(type: T, listener: (value: Events[T]) => void): () => void {
    const listeners = (this.#listeners[type] ??= new Set());
    listeners.add(listener);
    return () => listeners.delete(listener);
  }

  /** Adds a listener for the next event only. */
  once<T extends keyof Events>(type: T, listener: (value: Events[T]) => void) {
    const end = this.on(type, (value) => {
      end();
      listener(value);
    });
  }

  /** Calls the current listeners. An exception in one does not affect the others. */
  emit<T extends keyof Events>(type: T, value: Events[T]) {
    for (const listener of [...(this.#listeners[type] ?? [])]) {
      try {
        listener(value);
      } catch (error) {
        reportError(error);
      }
    }
  }
}
