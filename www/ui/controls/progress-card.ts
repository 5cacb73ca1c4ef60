/** A card that shows how far something has got, and may offer to cancel it. */

import '../styles/waiting.css';
import { element, setText, type Attributes } from '../dom.ts';

const button = (label: string, onclick: () => void, attributes: Attributes = {}) =>
  element('button.small.bordered', { onclick, ...attributes }, label);

export class ProgressCard {
  #text = element('p');
  #bar;
  #buttons = element('div.row-buttons');
  #element;

  /**
   * @param label of the card and of its bar
   * @param attributes of the card
   * @param cancel offered, if given, as a button and as Escape
   */
  constructor(label: string, place: HTMLElement, attributes: Attributes, cancel?: () => void) {
    const named = { 'aria-label': label };
    this.#bar = element('progress', { max: 1, ...named });
    const words = element('div.import', this.#text, this.#bar);
    const all = { ...attributes, ...named, role: 'group' };
    this.#element = element('div', all, words, this.#buttons);
    place.append(this.#element);
    if (!cancel) return;
    this.#buttons.append(button('Cancel', cancel));
    this.#element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      cancel();
    });
  }

  /** @param part fraction from 0 to 1; null if unknown */
  show(text: string, part: number | null) {
    setText(this.#text, text);
    if (part === null) this.#bar.removeAttribute('value');
    else this.#bar.value = part;
  }

  /** Asks a question until the answer is yes. */
  async ask(question: string, yes: string): Promise<void> {
    setText(this.#text, question);
    this.#text.id = 'question';
    this.#bar.hidden = true;
    await new Promise<void>((done) => {
      // Screen readers read the question with the focused button.
      const go = button(yes, done, { 'aria-describedby': this.#text.id });
      this.#buttons.prepend(go);
      go.focus();
    });
    this.#text.id = '';
    this.#buttons.firstElementChild?.remove();
    this.#bar.hidden = false;
  }

  remove() {
    this.#element.remove();
  }
}
