/** Palette of the kinds of constraints: radio buttons with drawings, the paper's kinds first. */

import { element } from '../dom.ts';
import { sketch } from './sketch.ts';
import type { KindInfo } from '../../solver/types.ts';

export class KindChoices {
  element = element('div.kinds');
  #chosen;
  /** The ids of the displayed kinds. */
  #shown = '';

  constructor(chosen: (kind: KindInfo) => void) {
    this.#chosen = chosen;
  }

  show(kinds: KindInfo[], chosenId: string) {
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

  /** Focuses the tile of a kind, which scrolls it into view. */
  focus(id: string) {
    this.#radio(id)?.focus();
  }

  #radio(id: string): HTMLInputElement | null {
    return this.element.querySelector(`#new-kind-${CSS.escape(id)}`);
  }

  #palette(kinds: KindInfo[]) {
    return element('div.palette', ...kinds.map((kind) => this.#tile(kind)));
  }

  #tile(kind: KindInfo) {
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
