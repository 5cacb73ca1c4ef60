/** What is shown while something takes long: loading the solver, and the work of a worker. */

import { ProgressCard } from '../ui/controls/progress-card.ts';
import { byId } from '../ui/dom.ts';
import { megabytes } from '../ui/words.ts';
import type { Store } from '../store/state.ts';

/** The card over the view while the solver is loaded. */
let loading: ProgressCard | null = null;

/**
 * Shows how much of the solver is loaded; called only if that takes a while.
 * @param bytes loaded so far
 * @param all total bytes
 */
export function showLoading(store: Store, bytes: number, all: number) {
  loading ??= untilReady(store);
  const [loaded, total] = [bytes, all].map(megabytes);
  loading.show(`Loading the solver · ${loaded} of ${total} MB`, bytes / all);
}

function untilReady(store: Store) {
  const card = new ProgressCard('Loading progress', byId('main'), { id: 'loading', class: 'card' });
  // The kinds arrive with the solver, possibly before this call.
  store.subscribe(['kinds'], ({ kinds }) => {
    if (kinds.length > 0) card.remove();
  });
  return card;
}

/** The card of each worker that works. */
const cards = new Map<string, ProgressCard>();

/**
 * Shows that a worker works, with an offer to cancel that, or removes what showed it.
 * @param worker its name
 */
export function offerCancel(worker: string, busy: boolean, abandon: () => void) {
  cards.get(worker)?.remove();
  cards.delete(worker);
  if (!busy) return;
  const attributes = { class: 'message notice', 'data-worker': worker };
  const card = new ProgressCard('Long work', byId('messages'), attributes, abandon);
  card.show('Working …', null);
  cards.set(worker, card);
}
