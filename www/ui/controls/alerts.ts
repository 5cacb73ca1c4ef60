/** Important messages: errors and notices, in the page's only `role="alert"`. */

import { signal } from '@preact/signals';
import { element, removeKeepingFocus } from '../dom.ts';
import { showInFront } from './dialog.ts';
import { button, closeButton } from './fields.ts';

/** A button of a message. */
export type Offer = { label: string; action: () => void };

/** A message of the journal; `id` numbers them all. */
export interface Entry {
  id: number;
  time: Date;
  kind: 'error' | 'notice' | 'status';
  text: string;
}

/** The most entries of the journal; older ones are dropped. */
const MOST_ENTRIES = 500;
/** Messages are of one moment for so long, unless the user presses something between them. */
const MOMENT_MS = 2000;
/** The most messages at a time. */
const MOST_SHOWN = 3;

export class Alerts {
  #journal = signal<Entry[]>([]);
  /** What clears other messages of the view. */
  #others: (() => void)[] = [];
  #place;
  /** Where that is without a dialog. */
  #home;
  /** Whether the current message must not be replaced. */
  #isFatal = false;

  /** Those of a moment that is over, as by the user's last press. */
  #seen: Set<Element> = new Set();

  /** @param place the `role="alert"` */
  constructor(place: HTMLElement) {
    this.#place = place;
    this.#home = place.parentElement ?? document.body;
    for (const press of ['pointerdown', 'keydown'])
      window.addEventListener(press, () => (this.#seen = new Set(place.children)), true);
  }

  /**
   * Reports that a requested action failed.
   * @param offers what can be done about it
   * @returns withdraws the message, if it is still shown
   */
  error(message: string, ...offers: Offer[]): () => void {
    return this.#show(message, 'error', offers);
  }

  /**
   * Reports an event that the user did not request.
   * @param offers what can be done about it
   * @returns withdraws the message, if it is still shown
   */
  notice(message: string, ...offers: Offer[]): () => void {
    return this.#show(message, 'notice', offers);
  }

  /** Reports a fatal problem. Errors that it causes do not replace it. */
  stop(message: string, offer: Offer) {
    if (this.#isFatal) return;
    this.#remove(...this.#place.children);
    this.#show(message, 'error', [offer]);
    this.#isFatal = true;
  }

  /** The messages since the page was opened, oldest first; a component that reads them follows. */
  get journal(): readonly Entry[] {
    return this.#journal.value;
  }

  /** Adds a message to the journal. */
  note(text: string, kind: Entry['kind'] = 'status') {
    const before = this.#journal.peek();
    const last = before.at(-1);
    if (last?.text === text) return;
    const entry = { id: (last?.id ?? 0) + 1, time: new Date(), kind, text };
    this.#journal.value = [...before, entry].slice(-MOST_ENTRIES);
  }

  /** Clears all messages, as Escape does, and others of the view. */
  clear() {
    for (const clear of this.#others) clear();
    if (!this.#isFatal) this.#remove(...this.#place.children);
  }

  /** Also clears messages that are shown elsewhere. */
  clearWith(clear: () => void) {
    this.#others.push(clear);
  }

  #remove(...messages: Element[]) {
    for (const one of messages)
      if (one instanceof HTMLElement) removeKeepingFocus(one, () => one.remove());
  }

  /**
   * Shows a message in place of the previous one, whose action has been retried since. One that
   * offers something else stays: nothing else may offer that. So does another notice of the same moment,
   * as of one opening: nobody has read it.
   */
  #show(message: string, kind: 'error' | 'notice', offers: Offer[]) {
    this.note(message, kind);
    if (this.#isFatal) return () => {};
    const withdraw = () => {
      if (!shown.isConnected) return;
      this.#isFatal = false;
      this.#remove(shown);
    };
    const close = closeButton('Dismiss', withdraw);
    const buttons = offers.map(({ label, action }) => {
      const onclick = () => {
        withdraw();
        action();
      };
      return button(label, onclick, { class: 'small bordered' });
    });
    const offered = offers.map(({ label }) => label).join();
    const shown = element(
      'div',
      { class: `message ${kind}`, 'data-offers': offered },
      element('p', message),
      ...buttons,
      close,
    );
    const before = [...this.#place.querySelectorAll<HTMLElement>(':scope > *')];
    const isNew = (one: Element) =>
      one.matches('.notice') && !this.#seen.has(one) && one.firstChild?.textContent !== message;
    const stay = before.filter((one) =>
      one.dataset.offers ? one.dataset.offers !== offered : isNew(one),
    );
    stay.splice(0, stay.length + 1 - MOST_SHOWN);
    this.#remove(...before.filter((one) => !stay.includes(one)));
    this.#place.append(shown);
    setTimeout(() => this.#seen.add(shown), MOMENT_MS);
    showInFront(this.#place, this.#home);
    return withdraw;
  }
}
