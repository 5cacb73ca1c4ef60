/**
 * The card of the first visit: three hints, each leading to the next by doing what it says. Shown
 * once, and only over the example, which is solved when it opens.
 */

import { element, icon, leave, setText } from './dom.js';
import { declared, measureOfScene } from './measures.js';
import { recall, remember } from './stored.js';

const KEY = 'shape-up.hints';
const START = 'It began like this, yellow where it is worst. Press Run.';

/** @param {string} met what is true of every panel */
const hints = (met) => [
  `Solved: ${met}. Drag a blue dot: this stays true.`,
  'Press Reset to see how it began.',
  'Your turn: open a mesh of your own, or try another example.',
];

/**
 * @param {HTMLElement} card
 * @param {import("./state.js").Store} store
 */
export function firstHints(card, store) {
  if (recall(KEY) === 'done') return;
  const text = element('p');
  const close = element(
    'button',
    { type: 'button', class: 'tiny', 'aria-label': 'Dismiss hint', onclick: () => finish() },
    icon('close'),
  );
  card.replaceChildren(text, close);
  /** Hints that have been followed. */
  let at = 0;
  let drags = false;
  let runs = false;
  /** From the start, where nothing is solved. */
  let hasRun = false;
  let done = false;

  store.subscribe(['firstExample', 'document', 'numbers', 'running', 'dragged'], (state) => {
    if (done) return;
    const { firstExample, document, numbers, running, dragged } = state;
    if (!firstExample) {
      if (at > 0) finish();
      else card.hidden = true;
      return;
    }
    const about = declared(state, measureOfScene(state));
    if (!document || !numbers || !about) return;
    const isStart = numbers.iteration === 0;
    if (drags && dragged.length === 0) at = Math.max(at, 1);
    if (runs && !running) hasRun = true;
    drags = dragged.length > 0;
    runs = running && (runs || isStart);
    if (at === 1 && hasRun) at = 2;
    // Whoever has seen the last one has seen them all.
    if (at === 2) remember(KEY, 'done');
    setText(text, isStart && at < 2 ? START : hints(about.met)[at]);
    card.hidden = false;
  });

  function finish() {
    done = true;
    leave(card, () => (card.hidden = true));
    remember(KEY, 'done');
  }
}
