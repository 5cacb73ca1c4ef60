/** What is shown while something takes long: loading the solver, and the work of a worker. */

import '../ui/styles/waiting.css';
import { byId, element, removeKeepingFocus } from '../ui/dom.ts';
import { megabytes } from '../ui/words.ts';
import type { Store } from '../store/state.ts';

/** The card over the view while the solver is loaded. */
let shown: { text: HTMLElement; bar: HTMLProgressElement; card: HTMLElement } | null = null;

/**
 * Shows how much of the solver is loaded; called only if that takes a while.
 * @param bytes loaded so far
 * @param all total bytes
 */
export function showLoading(store: Store, bytes: number, all: number) {
  shown ??= show(store);
  const [loaded, total] = [bytes, all].map(megabytes);
  shown.text.textContent = `Loading the solver · ${loaded} of ${total} MB`;
  shown.bar.value = bytes / all;
}

function show(store: Store) {
  const text = element('p');
  const bar = element('progress', { max: 1, 'aria-label': 'Loading progress' });
  const card = element('div.card', { id: 'loading' }, text, bar);
  byId('main').append(card);
  // The kinds arrive with the solver, possibly before this call.
  store.subscribe(['kinds'], ({ kinds }) => {
    if (kinds.length > 0) card.remove();
  });
  return { text, bar, card };
}

/** The card of each worker that works. */
const cards = new Map<string, HTMLElement>();

/**
 * Shows that a worker works, with an offer to cancel that, or removes what showed it.
 * @param worker its name
 */
export function offerCancel(worker: string, busy: boolean, abandon: () => void) {
  const before = cards.get(worker);
  cards.delete(worker);
  if (before) removeKeepingFocus(before, () => before.remove());
  const messages = byId('messages');
  // Opening a large file shows its own message.
  if (!busy || messages.querySelector(':scope > :not(.work) .import')) return;
  const bar = element('progress', { 'aria-label': 'The solver is working' });
  const words = element('div.import', element('p', 'Working …'), bar);
  const cancel = element('button.small.bordered', { onclick: abandon }, 'Cancel');
  const attributes = { class: 'message notice work', role: 'group', 'aria-label': 'Long work' };
  const card = element('div', attributes, words, cancel);
  cards.set(worker, card);
  messages.append(card);
}
