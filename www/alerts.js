/** Messages that want to be read: errors and notices, in the page's one `role="alert"`. */

import { element, icon } from './dom.js';

export class Alerts {
  #place;

  /** @param {HTMLElement} place the `role="alert"` */
  constructor(place) {
    this.#place = place;
  }

  /** Something that was asked for did not happen. @param {string} message */
  error(message) {
    this.#show(message, 'error');
  }

  /** Something happened that was not asked for. @param {string} message */
  notice(message) {
    this.#show(message, 'notice');
  }

  clear() {
    this.#place.replaceChildren();
  }

  /**
   * The newest message only: an old one is about something that was tried again since.
   * @param {string} message
   * @param {"error" | "notice"} kind
   */
  #show(message, kind) {
    const close = element(
      'button',
      { type: 'button', class: 'tiny', 'aria-label': 'Dismiss', onclick: () => this.clear() },
      icon('close'),
    );
    const text = element('p', {}, message);
    this.#place.replaceChildren(element('div', { class: `message ${kind}` }, text, close));
  }
}
