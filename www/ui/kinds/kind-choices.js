/** Palette of the kinds of constraints: radio buttons with drawings, the paper's kinds first. */

import { element } from '../dom.js';
import { sketch } from './sketch.js';

/** @typedef {import("../../solver/messages.js").KindInfo} KindInfo */

export class KindChoices {
  element = element('div.kinds');
  #chosen;
  /** The ids of the displayed kinds. */
  #shown = '';

  /** @param {(kind: KindInfo) => void} chosen */
  constructor(chosen) {
    this.#chosen = chosen;
  }

  /**
   * @param {KindInfo[]} kinds
   * @param {string} chosenId
   */
  show(kinds, chosenId) {
    const shown = kinds.map((kind) => kind.id).join(' ');
    if (shown !== this.#shown) {
      this.#shown = shown;
      const focused = document.activeElement?.id;
      const own = kinds.filter((kind) => kind.paper);
      const others = kinds.filter((kind) => !kind.paper);
      this.element.replaceChildren(
        ...(own.length > 0 ? [this.#palette(own)] : []),
        ...(others.length > 0
          ? [element('p.quiet.heading', 'Other constraints'), this.#palette(others)]
          : []),
      );
      if (focused) document.getElementById(focused)?.focus();
    }
    const radio = this.#radio(chosenId);
    if (radio && !radio.checked) radio.checked = true;
  }

  /** Focuses the tile of a kind, which scrolls it into view. @param {string} id */
  focus(id) {
    this.#radio(id)?.focus();
  }

  /** @param {string} id @returns {HTMLInputElement | null} */
  #radio(id) {
    return this.element.querySelector(`#new-kind-${CSS.escape(id)}`);
  }

  /** @param {KindInfo[]} kinds */
  #palette(kinds) {
    return element('div.palette', ...kinds.map((kind) => this.#tile(kind)));
  }

  /** @param {KindInfo} kind */
  #tile(kind) {
    const summary = `new-kind-${kind.id}-summary`;
    const radio = element('input', {
      type: 'radio',
      name: 'new-kind',
      id: `new-kind-${kind.id}`,
      'aria-label': kind.label,
      'aria-describedby': summary,
      onchange: () => this.#chosen(kind),
    });
    return element(
      'label.tile',
      { title: kind.summary, style: `--chip: rgb(${kind.colour.join(' ')})` },
      radio,
      sketch(kind.sketch),
      element('span', kind.label),
      // The summary of the chosen kind is shown below the palette; screen readers get each.
      element('span.visually-hidden', { id: summary }, kind.summary),
    );
  }
}
