/** The message on the last run: one at a time, which another one replaces. */

import { signal } from '@preact/signals';
import { Emitter } from '../../solver/emitter.ts';
import { panelsCard } from '../../store/panels-card.ts';
import type { Store } from '../../store/state.ts';

/** A button of a message; pressing it withdraws the message first, unless that `stays`. */
export interface Offer {
  label: string;
  title?: string;
  stays?: boolean;
  act: () => unknown;
}

export interface Said {
  words: string;
  /** the numbers, and where they are shown else, or that they are shown only where there is room */
  numbers?: { words: string; elsewhere: 'in-legend' | 'in-rows' | 'where-room' };
  offers?: Offer[];
  /** what is still looked for */
  waits?: string;
}

export interface Message extends Said {
  /** whether it is on the card of the panels, which has the verdict on them */
  isOnCard: boolean;
}

/** Emits `left` when what was said last is said no longer, or its cause is gone. */
export class RunMessages extends Emitter<{ left: void }> {
  readonly now = signal<Message | null>(null);
  #store;

  constructor(store: Store) {
    super();
    this.#store = store;
  }

  /** Whether the card already shows the verdict on the panels. */
  hasCard() {
    return panelsCard(this.#store.get()) === 'verdict';
  }

  /** Shows a message in place of the current one. */
  say(said: Said): Message {
    this.withdraw();
    const message = { ...said, isOnCard: this.hasCard() };
    this.now.value = message;
    return message;
  }

  isShown(message: Message) {
    return this.now.value === message && (!message.isOnCard || this.hasCard());
  }

  /** Changes a message, if it is still shown. */
  turn(message: Message, change: Partial<Said>) {
    if (this.isShown(message)) this.now.value = { ...message, ...change };
  }

  /** @param message if it is still shown; any, without it */
  withdraw(message?: Message) {
    if (message && this.now.value !== message) return;
    this.now.value = null;
    this.emit('left', undefined);
  }
}
