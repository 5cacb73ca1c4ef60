/** Important messages: errors and notices, in the page's only `role="alert"`. */

import { signal } from '@preact/signals';
import { element, removeKeepingFocus } from '../dom.ts';
import { button, closeButton } from './fields.ts';

/** A button of a message. */
export type Offer = { label: string; action: () => void };

/** A message of the journal; `id` numbers them all. */
export interface Entry {
  id: number;
  time: Date;
  kind: 'error' | 'notice' | 'status';
  text: string;
}

/** The most entries of the journal; older ones are dropped. */
const MOST_ENTRIES = 500;

export class Alerts {
  #journal = signal<Entry[]>([]);
  /** What clears other messages of the view. */
  #others: (() => void)[] = [];
  #place;
  /** Whether the current message must not be replaced. */
  #isFatal = false;

  /** @param place the `role="alert"` */
  constructor(place: HTMLElement) {
    this.#place = place;
  }

  /**
   * Reports that a requested action failed.
   * @param offers what can be done about it
   * @returns withdraws the message, if it is still shown
   */
  error(message: string, ...offers: Offer[]): () => void {
    return this.#show(message, 'error', offers);
  }

  /**
   * Reports an event that the user did not request.
   * @param offers what can be done about it
   * @returns withdraws the message, if it is still shown
   */
  notice(message: string, ...offers: Offer[]): () => void {
    return this.#show(message, 'notice', offers);
  }

  /** Reports a fatal problem. Errors that it causes do not replace it. */
  stop(message: string, offer: Offer) {
    this.#show(message, 'error', [offer]);
    this.#isFatal = true;
  }

  /** The messages since the page was opened, oldest first; a component that reads them follows. */
  get journal(): readonly Entry[] {
    return this.#journal.value;
  }

  /** Adds a message to the journal. */
  note(text: string, kind: Entry['kind'] = 'status') {
    const before = this.#journal.peek();
    const last = before.at(-1);
    if (last?.text === text) return;
    const entry = { id: (last?.id ?? 0) + 1, time: new Date(), kind, text };
    this.#journal.value = [...before, entry].slice(-MOST_ENTRIES);
  }

  /** Clears the message, as Escape does, and others of the view. */
  clear() {
    for (const clear of this.#others) clear();
    if (!this.#isFatal) this.#clear();
  }

  /** Also clears messages that are shown elsewhere. */
  clearWith(clear: () => void) {
    this.#others.push(clear);
  }

  #clear() {
    this.#isFatal = false;
    removeKeepingFocus(this.#place, () => this.#place.replaceChildren());
  }

  /** Shows a message in place of the previous one, whose action has been retried since. */
  #show(message: string, kind: 'error' | 'notice', offers: Offer[] = []) {
    this.note(message, kind);
    if (this.#isFatal) return () => {};
    const close = closeButton('Dismiss', () => this.#clear());
    const text = element('p', message);
    const buttons = offers.map(({ label, action }) => {
      const onclick = () => {
        this.#clear();
        action();
      };
      return button(label, onclick, { class: 'small bordered' });
    });
    const shown = element('div', { class: `message ${kind}` }, text, ...buttons, close);
    this.#place.replaceChildren(shown);
    return () => {
      if (shown.isConnected) this.#clear();
    };
  }
}
