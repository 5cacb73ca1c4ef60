/** Progress of loading the solver, shown over the view if it takes a while. */

import '../../ui/styles/waiting.css';
import { byId, element } from '../../ui/dom.ts';
import type { Store } from '../../store/state.ts';

const MB = 1_000_000;
let shown: { text: HTMLElement; bar: HTMLProgressElement; card: HTMLElement } | null = null;

/**
 * @param bytes loaded so far
 * @param all total bytes
 */
export function showLoading(store: Store, bytes: number, all: number) {
  shown ??= show(store);
  const [here, whole] = [bytes, all].map((size) => (size / MB).toFixed(1));
  shown.text.textContent = `Loading the solver · ${here} of ${whole} MB`;
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
