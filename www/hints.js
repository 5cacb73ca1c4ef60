/**
 * The card of the first visit: three hints, each leading to the next by doing what it says. Shown
 * once, and only over the example.
 */

import { element, icon, leave } from './dom.js';
import { declared, measureOfScene } from './measures.js';
import { recall, remember } from './stored.js';

const KEY = 'shape-up.hints';
const LAST = 'Your turn: open a mesh of your own, or try another example.';

/**
 * What the hints say of a scene.
 * @param {import("./messages.js").FaceMeasure | undefined} measure
 */
function hintsFor(measure) {
  if (!measure) return ['Press Run: the mesh takes its shape.', 'Now drag a blue dot.', LAST];
  const { met } = measure;
  return [
    `These panels are not ${met}. Press Run.`,
    `Now they are. Drag a blue dot: the panels stay ${met}.`,
    LAST,
  ];
}

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
  let at = 0;
  let ran = false;
  let dragged = false;
  let done = false;

  store.subscribe(['firstExample', 'document', 'running', 'dragged'], (state) => {
    if (done) return;
    if (!state.firstExample) {
      if (at > 0) finish();
      else card.hidden = true;
      return;
    }
    if (!state.document) return;
    ran ||= state.running;
    if (at === 0 && ran && !state.running) at = 1;
    if (at <= 1 && dragged && state.dragged.length === 0) at = 2;
    dragged ||= state.dragged.length > 0;
    // Whoever has seen the last one has seen them all.
    if (at === 2) remember(KEY, 'done');
    text.textContent = hintsFor(declared(state, measureOfScene(state)))[at];
    card.hidden = false;
  });

  function finish() {
    done = true;
    leave(card, () => (card.hidden = true));
    remember(KEY, 'done');
  }
}
