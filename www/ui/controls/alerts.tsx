/** Important messages: errors and notices, in the page's only `role="alert"`. */

import { signal } from '@preact/signals';
import { render } from 'preact';
import { Button, CloseButton } from '../components/buttons.tsx';
import { showInFront } from './dialog.ts';

/** A button of a message. */
export type Offer = { label: string; action: () => void };

/** A message of the journal; `id` numbers them all. */
export interface Entry {
  id: number;
  time: Date;
  kind: 'error' | 'notice' | 'status';
  text: string;
}

/** A message that is shown. */
interface Message {
  id: number;
  kind: 'error' | 'notice';
  text: string;
  offers: Offer[];
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
  #seen: Set<Message> = new Set();
  #shown = signal<Message[]>([]);
  #last = 0;

  /**
   * The messages are a tree of their own: they also tell what went wrong with that of the page.
   * @param place the `role="alert"`
   */
  constructor(place: HTMLElement) {
    this.#place = place;
    this.#home = place.parentElement ?? document.body;
    for (const press of ['pointerdown', 'keydown'])
      window.addEventListener(press, () => (this.#seen = new Set(this.#shown.peek())), true);
    const Messages = () => (
      <>
        {this.#shown.value.map((message) => (
          <div key={message.id} class={`message ${message.kind}`}>
            <p>{message.text}</p>
            {message.offers.map(({ label, action }) => (
              <Button
                key={label}
                class="small bordered"
                onClick={() => {
                  this.#withdraw(message);
                  action();
                }}
              >
                {label}
              </Button>
            ))}
            <CloseButton label="Dismiss" onClick={() => this.#withdraw(message)} />
          </div>
        ))}
      </>
    );
    render(<Messages />, place);
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
    this.#shown.value = [];
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
    if (!this.#isFatal) this.#shown.value = [];
  }

  /** Also clears messages that are shown elsewhere. */
  clearWith(clear: () => void) {
    this.#others.push(clear);
  }

  #withdraw(message: Message) {
    const others = this.#shown.peek().filter((one) => one !== message);
    if (others.length === this.#shown.peek().length) return;
    this.#isFatal = false;
    this.#shown.value = others;
  }

  /**
   * Shows a message in place of the previous one, whose action has been retried since. One that
   * offers something else stays: nothing else may offer that. So does another notice of the same moment,
   * as of one opening: nobody has read it.
   */
  #show(text: string, kind: Message['kind'], offers: Offer[]) {
    this.note(text, kind);
    if (this.#isFatal) return () => {};
    const message = { id: ++this.#last, kind, text, offers };
    const wordsOf = (one: Message) => one.offers.map(({ label }) => label).join();
    const isNew = (one: Message) =>
      one.kind === 'notice' && !this.#seen.has(one) && one.text !== text;
    const stay = this.#shown
      .peek()
      .filter((one) => (one.offers.length > 0 ? wordsOf(one) !== wordsOf(message) : isNew(one)));
    this.#shown.value = [...stay.slice(-MOST_SHOWN + 1), message];
    setTimeout(() => this.#seen.add(message), MOMENT_MS);
    showInFront(this.#place, this.#home);
    return () => this.#withdraw(message);
  }
}
