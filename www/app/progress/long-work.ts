/** Offers to cancel long work of the solver. Loaded when such work occurs. */

import '../../ui/styles/waiting.css';
import { byId, element, removeKeepingFocus } from '../../ui/dom.ts';
import type { SolverClient } from '../../solver/solver-client.ts';

let card: HTMLElement | null = null;

export function offerCancel(busy: boolean, solver: SolverClient) {
  const before = card;
  card = null;
  if (before) removeKeepingFocus(before, () => before.remove());
  const messages = byId('messages');
  // Opening a large file shows its own message.
  if (!busy || messages.querySelector('.import')) return;
  const bar = element('progress', { 'aria-label': 'The solver is working' });
  const words = element('div.import', element('p', 'Working …'), bar);
  const cancel = element('button.small.bordered', { onclick: () => solver.abandon() }, 'Cancel');
  const attributes = { class: 'message notice', role: 'group', 'aria-label': 'Long work' };
  card = element('div', attributes, words, cancel);
  messages.append(card);
}
