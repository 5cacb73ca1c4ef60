/**
 * Shows the original instead of the current shape while the user holds a key or a button. The
 * document does not change, and a run continues in the background.
 */

import { messageOf } from '../solver/errors.ts';
import { newestOnly } from '../store/latest-only.ts';
import type { Store } from '../store/state.ts';
import type { Actions } from '../store/actions.ts';

const STATUS = 'Showing the original while held';
/** A button with a click action shows the original if held at least this long, in milliseconds. */
const LONG_PRESS_MS = 300;
/** After this time the key that asked for the original is released, in milliseconds. */
const RELEASED_MS = 400;

export class HoldOriginal {
  #store;
  #actions;
  #isHeld = false;
  #newest = newestOnly(() => this.#store.get().model);
  /** The status text before. */
  #status = '';

  constructor(store: Store, actions: Actions) {
    this.#store = store;
    this.#actions = actions;
    for (const type of ['keyup', 'blur', 'pointerup', 'pointercancel'])
      window.addEventListener(type, () => this.end());
  }

  /** Shows the original until a key or the pointer is released. */
  async begin() {
    if (this.#isHeld) return;
    this.#isHeld = true;
    const { measure, status } = this.#store.get();
    this.#status = status;
    try {
      const original = await this.#newest(
        Promise.all([
          this.#actions.originalPositions(),
          measure ? this.#actions.ask.originalValues(measure) : null,
        ]),
      );
      if (!original || !this.#isHeld) return;
      const [positions, values] = original;
      this.#actions.look({ heldOriginal: { positions, values }, status: STATUS });
    } catch (error) {
      this.#actions.setStatus(messageOf(error));
    }
  }

  /** Shows the original until the next press ends, without anything held. */
  showUntilPress() {
    setTimeout(() => void this.begin(), RELEASED_MS);
  }

  end() {
    if (!this.#isHeld) return;
    this.#isHeld = false;
    const { heldOriginal, status } = this.#store.get();
    if (!heldOriginal) return;
    this.#actions.look({ heldOriginal: null, status: status === STATUS ? this.#status : status });
  }

  /**
   * Makes a button show the original while it is pressed, by pointer or key. A button with an
   * action of its own (`clicks`) performs that only after a short press.
   */
  bind(button: HTMLElement, { clicks = false }: { clicks?: boolean } = {}) {
    let timer = 0;
    let isLong = false;
    button.addEventListener('pointerdown', ({ button: which }) => {
      if (which !== 0) return;
      isLong = false;
      const begin = () => {
        isLong = true;
        void this.begin();
      };
      if (clicks) timer = window.setTimeout(begin, LONG_PRESS_MS);
      else begin();
    });
    for (const type of ['pointerup', 'pointerleave', 'pointercancel'])
      button.addEventListener(type, () => clearTimeout(timer));
    button.addEventListener('pointerleave', () => this.end());
    // A long touch would open the browser's context menu.
    button.addEventListener('contextmenu', (event) => event.preventDefault());
    // The click of a long press is none; that of a key has no pointer, and a detail of 0.
    const swallow = (event: MouseEvent) =>
      isLong && event.detail > 0 && event.stopImmediatePropagation();
    button.addEventListener('click', swallow, true);
    if (clicks) return;
    button.addEventListener('keydown', ({ key }) => {
      if (key === ' ' || key === 'Enter') void this.begin();
    });
  }
}
