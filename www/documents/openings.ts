/**
 * The order in which openings were begun. Reading a file and fetching an example take time, so that
 * a later opening may be ready first: the latest one wins, unless it is refused.
 */

/** An opening under way. Whatever opens a model has one, from the press that begins it. */
export interface Opening {
  /**
   * Waits until all later openings have ended.
   * @returns false if one of them has opened its model, so that this one must open nothing
   */
  isWanted: () => Promise<boolean>;
  /** Returns the answer of the user, until which its model is not coming. */
  asks: <T>(answer: Promise<T>) => Promise<T>;
  /** Notes that its model is open. */
  opened: () => void;
  /** Aborted when a later one has opened its model: this one is of no use any longer. */
  overtaken: AbortSignal;
}

export class Openings {
  /** Number of openings begun. */
  #begun = 0;
  /** Number of the latest one whose model was opened. */
  #opened = 0;
  /** Those that have not opened their models yet, by number: when they end, and what stops them. */
  #coming: Map<number, { end: Promise<unknown>; stop: AbortController }> = new Map();
  /** Those of them that wait for an answer of the user. */
  #asking: Set<number> = new Set();
  #begins;

  /** @param begins called when one begins; what it says stays until the next one */
  constructor(begins: () => void = () => {}) {
    this.#begins = begins;
  }

  /**
   * Begins an opening.
   * @param open uses the opening given to it for all that it opens
   * @returns what `open` returns; null if it fails, but a later opening has opened its model
   */
  begin<T>(open: (opening: Opening) => Promise<T>): Promise<T | null> {
    const number = ++this.#begun;
    this.#begins();
    const stop = new AbortController();
    const opening = {
      isWanted: () => this.#isWanted(number),
      asks: <T>(answer: Promise<T>) => {
        this.#asking.add(number);
        return answer.finally(() => this.#asking.delete(number));
      },
      opened: () => {
        this.#opened = Math.max(this.#opened, number);
        this.#coming.delete(number);
        for (const [other, { stop }] of this.#coming) if (other < number) stop.abort();
      },
      overtaken: stop.signal,
    };
    const done = open(opening).catch(async (error) => {
      if (await opening.isWanted()) throw error;
      return null;
    });
    const end = () => this.#coming.delete(number);
    this.#coming.set(number, { end: done.then(end, end), stop });
    return done;
  }

  /**
   * Resolves when all openings have ended whose models are coming; null if none. One that waits for the
   * user may open nothing.
   */
  get coming(): Promise<unknown> | null {
    const coming = [...this.#coming].filter(([number]) => !this.#asking.has(number));
    return coming.length > 0 ? Promise.all(coming.map(([, { end }]) => end)) : null;
  }

  async #isWanted(number: number) {
    const later = () => [...this.#coming].filter(([other]) => other > number);
    for (let those = later(); those.length > 0; those = later())
      await Promise.all(those.map(([, { end }]) => end));
    return this.#opened <= number;
  }
}
