/**
 * The card of the first visit: below the purpose of the page, which is in index.html, three hints;
 * following one leads to the next. Shown once, and only over the example, which is solved on
 * opening. Its statement of the accuracy is updated continuously, also during a drag.
 */

import { closeButton } from '../ui/controls/fields.ts';
import { RENEW_MS, byId, element, removeKeepingFocus, setText, throttled } from '../ui/dom.ts';
import { declared, toleranceOf, valueInWords, worstOf } from '../store/colours/measures.ts';
import { getItem, setItem } from '../ui/safe-storage.ts';
import type { Store } from '../store/state.ts';

const KEY = 'shape-up.hints';
const START = 'This is the original. Press Run.';

/** @param now statement that holds for every panel */
const hints = (now: string) => [
  `${now} Drag a blue handle: the shape is solved again as you drag.`,
  'Press Reset to see the original.',
  'Your turn: open a mesh of your own, or try another example.',
];

export function firstHints(card: HTMLElement, store: Store) {
  // index.html hides the card in this case.
  if (getItem(KEY) === 'done') return;
  const text = element('p.said');
  const close = closeButton('Dismiss hint', () => finish());
  byId('claim').after(text, close);
  /** Number of hints followed. */
  let at = 0;
  let drags = false;
  let runs = false;
  /** Whether a run from the unsolved start has ended. */
  let hasRun = false;
  let done = false;

  const update = throttled(RENEW_MS, () => {
    const state = store.get();
    const { document, numbers, firstExample } = state;
    const about = declared(state, document?.measure ?? null);
    if (done || !document || !numbers || !about || !firstExample) return;
    const worst = worstOf(state, about.id);
    const value = () => valueInWords(about, worst, document.units, toleranceOf(state, about));
    const how = worst === 0 ? 'exactly' : `within ${value()}`;
    const met = `${about.met[0].toUpperCase()}${about.met.slice(1)}, ${how}.`;
    setText(text, numbers.iteration === 0 && at < 2 ? START : hints(met)[at]);
    delete window.document.documentElement.dataset.known;
    card.hidden = false;
  });

  store.subscribe(['firstExample', 'document', 'numbers', 'running', 'dragged'], (state) => {
    if (done) return;
    const { firstExample, document, numbers, running, dragged } = state;
    if (!firstExample) {
      if (at > 0) finish();
      else if (document) card.hidden = true;
      return;
    }
    if (!document || !numbers) return;
    const isStart = numbers.iteration === 0;
    if (drags && dragged.length === 0) at = Math.max(at, 1);
    if (runs && !running) hasRun = true;
    drags = dragged.length > 0;
    runs = running && (runs || isStart);
    if (at === 1 && hasRun) at = 2;
    // The hints are done once the last one is shown.
    if (at === 2) setItem(KEY, 'done');
    update();
  });

  function finish() {
    done = true;
    removeKeepingFocus(card, () => (card.hidden = true));
    setItem(KEY, 'done');
  }
}
