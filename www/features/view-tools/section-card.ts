/**
 * The card of the section plane: its axis, its position and the side that stays visible. Shown
 * while there is a section.
 */

import { button, choice, closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import type { Section, Store } from '../../store/state.ts';
import type { Viewport } from '../../viewport/viewport.ts';
import type { Actions } from '../../store/actions.ts';

const AXES = ['x', 'y', 'z'];

export class SectionCard {
  #card;
  #axis;
  #at;
  #turn;

  constructor(store: Store, viewport: Viewport, actions: Actions) {
    const set = (change: Partial<Section>) => {
      const { section } = store.get();
      if (section) actions.look({ section: { ...section, ...change } });
    };
    this.#axis = choice(
      { 'aria-label': 'Section across' },
      (axis) => set({ axis: Number(axis) }),
      AXES.map((axis, i) => [`${i}`, axis] as const),
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
