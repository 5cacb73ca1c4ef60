/** Messages that want to be read: errors and notices, in the page's one `role="alert"`. */

import { element, icon, leave } from './dom.js';

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

  /**
   * Something happened that was not asked for.
   * @param {string} message
   * @param {{ label: string, action: () => void }} [offer] what can be done about it
   */
  notice(message, offer) {
    this.#show(message, 'notice', offer);
  }

  clear() {
    leave(this.#place, () => this.#place.replaceChildren());
  }

  /**
   * The newest message only: an old one is about something that was tried again since.
   * @param {string} message
   * @param {"error" | "notice"} kind
   * @param {{ label: string, action: () => void }} [offer]
   */
  #show(message, kind, offer) {
    const close = element(
      'button',
      { type: 'button', class: 'tiny', 'aria-label': 'Dismiss', onclick: () => this.clear() },
      icon('close'),
    );
    const text = element('p', {}, message);
    const act = () => {
      this.clear();
      offer?.action();
    };
    const offers = offer
      ? [element('button', { type: 'button', class: 'small bordered', onclick: act }, offer.label)]
      : [];
    this.#place.replaceChildren(
      element('div', { class: `message ${kind}` }, text, ...offers, close),
    );
  }
}
