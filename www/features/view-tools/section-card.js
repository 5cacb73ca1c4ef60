/**
 * The card of the section plane: its axis, its position and the side that stays visible. Shown
 * while there is a section.
 */

import { button, choice, closeButton } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';

const AXES = ['x', 'y', 'z'];

export class SectionCard {
  #card;
  #axis;
  #at;
  #turn;

  /**
   * @param {import("../../store/state.js").Store} store
   * @param {import("../../viewport/viewport.js").Viewport} viewport
   * @param {import("../../store/actions.js").Actions} actions
   */
  constructor(store, viewport, actions) {
    /** @param {Partial<import("../../store/state.js").Section>} change */
    const set = (change) => {
      const { section } = store.get();
      if (section) actions.look({ section: { ...section, ...change } });
    };
    this.#axis = choice(
      { 'aria-label': 'Section across' },
      (axis) => set({ axis: Number(axis) }),
      AXES.map((axis, i) => /** @type {const} */ ([`${i}`, axis])),
    );
    this.#at = element('input', {
      ...{ type: 'range', min: '0', max: '1', step: '0.005' },
      'aria-label': 'Position of the section',
      oninput: () => set({ at: this.#at.valueAsNumber }),
    });
    this.#turn = button('Other side', () => set({ turned: !store.get().section?.turned }));
    this.#card = element(
      'div.card',
      { id: 'section', role: 'group', 'aria-label': 'Section', hidden: true },
      element('label', 'Section ', this.#axis),
      this.#at,
      this.#turn,
      closeButton('End the section', () => actions.look({ section: null })),
    );
    viewport.element.after(this.#card);
    store.subscribe(['section'], ({ section }) => {
      this.#card.hidden = !section;
      if (!section) return;
      this.#axis.value = `${section.axis}`;
      this.#at.valueAsNumber = section.at;
      this.#turn.setAttribute('aria-pressed', `${section.turned}`);
    });
  }
}
