/**
 * The question for the unit and the vertical axis after a file that does not say them, with what was
 * guessed chosen already. On a phone one line below the view, which covers nothing of the model.
 */

import './style/frame-question.css';
import { element, icon, leave } from './dom.js';

export class FrameQuestion {
  #place;
  #store;
  #units;
  #change;

  /**
   * @param {HTMLElement} place
   * @param {import("./units.js").Store} store
   * @param {string[]} units to choose from
   * @param {(part: Partial<import("./units.js").Frame>) => Promise<void>} change
   */
  constructor(place, store, units, change) {
    this.#place = place;
    this.#store = store;
    this.#units = units;
    this.#change = change;
    store.subscribe(['document'], ({ document }) => {
      for (const chip of place.querySelectorAll('button[data-value]')) {
        if (!(chip instanceof HTMLElement) || !document) continue;
        const now = chip.dataset.part === 'up' ? document.up : document.units;
        chip.setAttribute('aria-pressed', String(chip.dataset.value === now));
      }
    });
  }

  /** @param {string} name of the file */
  ask(name) {
    this.#place.replaceChildren(
      element(
        'div',
        { class: 'message notice frame-chips', role: 'group', 'aria-label': 'Unit and up axis' },
        element('p', {}, `${name} says neither its unit nor which axis is up. This is guessed:`),
        this.#chips('Up', 'up', ['z', 'y']),
        element('div', { class: 'all-chips' }, this.#chips('Unit', 'units', this.#units)),
        element(
          'button',
          { type: 'button', class: 'small primary', onclick: () => this.#accept() },
          'That is right',
        ),
        element(
          'button',
          {
            type: 'button',
            class: 'tiny',
            'aria-label': 'Dismiss',
            onclick: () => this.#close(),
          },
          icon('close'),
        ),
      ),
    );
    // Where not all of them have room, what was guessed has.
    for (const chip of this.#place.querySelectorAll('[aria-pressed="true"]'))
      chip.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }

  #close() {
    leave(this.#place, () => this.#place.replaceChildren());
  }

  async #accept() {
    // Nothing changes, but it will not be asked again.
    await this.#change({});
    this.#close();
  }

  /**
   * @param {string} label
   * @param {"up" | "units"} part
   * @param {string[]} values
   */
  #chips(label, part, values) {
    const now = this.#store.get().document?.[part];
    return element(
      'div',
      { class: 'segmented', role: 'group', 'aria-label': label },
      element('span', { class: 'quiet', 'aria-hidden': 'true' }, label),
      ...values.map((value) =>
        element(
          'button',
          {
            type: 'button',
            'data-part': part,
            'data-value': value,
            'aria-pressed': String(value === now),
            onclick: () => this.#change({ [part]: value }),
          },
          value || 'none',
        ),
      ),
    );
  }
}
