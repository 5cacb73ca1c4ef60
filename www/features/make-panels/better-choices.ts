/** Buttons for presses that end better than the last one, as far as they were tried. */

import { button } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import type { BetterPress, PanelVerdict } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

const LOOKING = 'Looking for better choices …';

export class BetterChoices {
  readonly group = element('div.better', {
    role: 'group',
    'aria-label': 'Better choices',
    hidden: true,
  });
  #app;
  #press;
  #changed;
  /** The shape and the tolerance for which they were looked for. */
  #triedFor = '';

  /**
   * @param press what a button does
   * @param changed is called when there are other buttons
   */
  constructor(app: AppContext, press: (press: BetterPress) => unknown, changed: () => void) {
    this.#app = app;
    this.#press = press;
    this.#changed = changed;
  }

  /** Looks for presses that end better than `verdict`; once for each shape. */
  async find(verdict: PanelVerdict) {
    const { solver, actions } = this.#app;
    const shape = solver.geometry?.generation;
    const asked = `${shape} ${verdict.tolerance} ${verdict.required}`;
    if (this.#triedFor === asked || !verdict.required) return;
    this.#triedFor = asked;
    let found: BetterPress[] = [];
    const show = (words: string) => {
      if (this.#triedFor === asked) this.#show(found, words);
    };
    show(LOOKING);
    const take = (presses: BetterPress[]) => {
      found = presses;
      show(LOOKING);
      actions.suggest(shape, presses);
    };
    const ended = await actions.trials.betterPresses(take).catch(() => null);
    show('');
    // Something has changed meanwhile: the next verdict asks again.
    if (ended === false && this.#triedFor === asked) this.#triedFor = '';
  }

  /** Shows none. */
  clear() {
    this.#triedFor = '';
    this.#show([], '');
  }

  #show(presses: BetterPress[], words: string) {
    const buttons = presses.map((press) =>
      button(`${press.label}: ${press.words}`, () => this.#press(press), { class: 'bordered' }),
    );
    buttons[0]?.classList.add('recommended');
    this.group.replaceChildren(...buttons, ...(words ? [element('p.quiet', words)] : []));
    this.group.hidden = buttons.length === 0 && !words;
    this.#changed();
  }
}
