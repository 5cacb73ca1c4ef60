/** Important messages: errors and notices, in the page's only `role="alert"`. */

import { element, removeKeepingFocus } from '../dom.js';
import { button, closeButton } from './fields.js';

/** A button of a message. @typedef {{ label: string, action: () => void }} Offer */

/** The most entries of the journal; older ones are dropped. */
const MOST_ENTRIES = 500;

export class Alerts {
  /**
   * The messages since the page was opened, oldest first.
   * @type {{ time: Date, kind: "error" | "notice" | "status", text: string }[]}
   */
  journal = [];
  /** @type {(() => void) | undefined} */
  #listener;
  #place;
  /** Whether the current message must not be replaced. */
  #isFatal = false;

  /** @param {HTMLElement} place the `role="alert"` */
  constructor(place) {
    this.#place = place;
  }

  /**
   * Reports that a requested action failed.
   * @param {string} message
   * @param {...Offer} offers what can be done about it
   */
  error(message, ...offers) {
    this.#show(message, 'error', offers);
  }

  /**
   * Reports an event that the user did not request.
   * @param {string} message
   * @param {...Offer} offers what can be done about it
   */
  notice(message, ...offers) {
    this.#show(message, 'notice', offers);
  }

  /**
   * Reports a fatal problem. Errors that it causes do not replace it.
   * @param {string} message
   * @param {Offer} offer
   */
  stop(message, offer) {
    this.#show(message, 'error', [offer]);
    this.#isFatal = true;
  }

  /** Calls `listener` after every message. @param {() => void} listener */
  listen(listener) {
    this.#listener = listener;
  }

  /**
   * Adds a message to the journal.
   * @param {string} text
   * @param {"error" | "notice" | "status"} [kind]
   */
  note(text, kind = 'status') {
    if (this.journal.at(-1)?.text === text) return;
    this.journal.push({ time: new Date(), kind, text });
    if (this.journal.length > MOST_ENTRIES) this.journal.shift();
    this.#listener?.();
  }

  clear() {
    if (!this.#isFatal) this.#clear();
  }

  #clear() {
    this.#isFatal = false;
    removeKeepingFocus(this.#place, () => this.#place.replaceChildren());
  }

  /**
   * Shows a message in place of the previous one, whose action has been retried since.
   * @param {string} message
   * @param {"error" | "notice"} kind
   * @param {Offer[]} [offers]
   */
  #show(message, kind, offers = []) {
    this.note(message, kind);
    if (this.#isFatal) return;
    const close = closeButton('Dismiss', () => this.#clear());
    const text = element('p', message);
    const buttons = offers.map(({ label, action }) => {
      const onclick = () => {
        this.#clear();
        action();
      };
      return button(label, onclick, { class: 'small bordered' });
    });
    this.#place.replaceChildren(
      element('div', { class: `message ${kind}` }, text, ...buttons, close),
    );
  }
}
