/** Important messages: errors and notices, in the page's only `role="alert"`. */

import { element, removeKeepingFocus } from '../dom.ts';
import { button, closeButton } from './fields.ts';

/** A button of a message. */
export type Offer = { label: string; action: () => void };

/** The most entries of the journal; older ones are dropped. */
const MOST_ENTRIES = 500;

export class Alerts {
  /** The messages since the page was opened, oldest first. */
  journal: { time: Date; kind: 'error' | 'notice' | 'status'; text: string }[] = [];
  #listener: (() => void) | undefined;
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

  /** Calls `listener` after every message. */
  listen(listener: () => void) {
    this.#listener = listener;
  }

  /** Adds a message to the journal. */
  note(text: string, kind: 'error' | 'notice' | 'status' = 'status') {
    if (this.journal.at(-1)?.text === text) return;
    this.journal.push({ time: new Date(), kind, text });
    if (this.journal.length > MOST_ENTRIES) this.journal.shift();
    this.#listener?.();
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
