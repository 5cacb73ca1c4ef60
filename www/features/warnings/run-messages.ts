/** The message on the last run: one at a time, which another one replaces. */

import { signal } from '@preact/signals';
import { panelsCard } from '../../store/panels-card.ts';
import type { AppContext } from '../../app/context.ts';

/** A button of a message; pressing it withdraws the message first, unless that `stays`. */
export interface Offer {
  label: string;
  title?: string;
  stays?: boolean;
  /** whether it changes what was solved, instead of showing it */
  changes?: boolean;
  act: () => unknown;
}

export interface Message {
  /** the result of the run, which the card of the panels says itself */
  result?: string;
  words: string;
  /** whether it is a problem, a question, or about work that goes on: not yet done with */
  isOpen?: boolean;
  /** the numbers, and where they are shown else, or that they are shown only where there is room */
  numbers?: { words: string; elsewhere: 'in-legend' | 'in-rows' | 'where-room' };
  offers?: Offer[];
  /** what is still looked for */
  waits?: string;
  /** whether it could be read on the card when it was said */
  wasOnCard?: boolean;
}

export class RunMessages {
  readonly now = signal<Message | null>(null);
  #app;

  constructor(app: Pick<AppContext, 'store' | 'actions'>) {
    this.#app = app;
  }

  /** Shows a message in place of the current one. */
  say(said: Message): Message {
    this.withdraw();
    const wasOnCard = panelsCard(this.#app.store.get()) === 'verdict';
    return (this.now.value = { ...said, wasOnCard });
  }

  isShown(message: Message) {
    return this.now.value === message;
  }

  /** Changes a message, if it is still shown. */
  update(message: Message, change: Partial<Message>) {
    if (this.isShown(message)) this.now.value = { ...message, ...change };
  }

  /**
   * Withdraws what was said, and its marks, also those that were shown again after it.
   * @param message if it is still shown; any, without it
   */
  withdraw(message?: Message) {
    if (message && !this.isShown(message)) return;
    this.now.value = null;
    this.#app.actions.tint('unmet', null);
  }
}
