/** Offers to cancel long work of a worker. */

import '../../ui/styles/waiting.css';
import { byId, element, removeKeepingFocus } from '../../ui/dom.ts';

/** The card of each worker that works. */
const cards = new Map<string, HTMLElement>();

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
