/** Messages that want to be read: errors and notices, in the page's one `role="alert"`. */

import { element, leave } from '../dom.js';
import { button, closeButton } from './fields.js';

/** What can be done about a message. @typedef {{ label: string, action: () => void }} Offer */

/** The oldest ones beyond so many are forgotten. */
const MOST_ENTRIES = 500;

export class Alerts {
  /** What was said since the page was opened, oldest first. @type {{ time: Date, kind: "error" | "notice" | "status", text: string }[]} */
  journal = [];
  /** @type {(() => void) | undefined} */
  #listener;
  #place;
  /** What is shown is not to be covered. */
  #stays = false;

  /** @param {HTMLElement} place the `role="alert"` */
  constructor(place) {
    this.#place = place;
  }

  /**
   * Something that was asked for did not happen.
   * @param {string} message
   * @param {...Offer} offers what can be done about it
   */
  error(message, ...offers) {
    this.#show(message, 'error', offers);
  }

  /**
   * Something happened that was not asked for.
   * @param {string} message
   * @param {...Offer} offers what can be done about it
   */
  notice(message, ...offers) {
    this.#show(message, 'notice', offers);
  }

  /**
   * Something is missing without which nothing works. It is not covered by what fails because of it.
   * @param {string} message
   * @param {Offer} offer
   */
  stop(message, offer) {
    this.#show(message, 'error', [offer]);
    this.#stays = true;
  }

  /** Calls `listener` after everything that is said. @param {() => void} listener */
  listen(listener) {
    this.#listener = listener;
  }

  /**
   * Keeps what was said.
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
    if (!this.#stays) this.#clear();
  }

  #clear() {
    this.#stays = false;
    leave(this.#place, () => this.#place.replaceChildren());
  }

  /**
   * The newest message only: an old one is about something that was tried again since.
   * @param {string} message
   * @param {"error" | "notice"} kind
   * @param {Offer[]} [offers]
   */
  #show(message, kind, offers = []) {
    this.note(message, kind);
    if (this.#stays) return;
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
