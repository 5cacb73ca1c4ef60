/**
 * Reports and marks vertices that no constraint acts on, which stay in place while the rest moves.
 * The message offers to let them follow or to fix them.
 */

import { button, closeButton } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';
import { count } from '../../ui/format.js';

/** The colour of their dots, sRGB bytes. @type {[number, number, number]} */
const COLOUR = [214, 132, 24];
const SMALL = { class: 'small bordered' };

/** @param {import("../../app/context.js").AppContext} app */
export function watchFreeVertices({ store, actions }) {
  const place = element('div', { 'aria-live': 'polite' });
  document.getElementById('messages')?.append(place);
  /** The tint of the free vertices. @type {import("../../store/state.js").Tint | null} */
  let tint = null;
  /** Number of free vertices in the last message, also if it was closed. */
  let reported = 0;

  function clear() {
    place.replaceChildren();
    if (store.get().tint === tint) actions.tint(null);
    tint = null;
  }

  store.subscribe(['document'], async ({ document, model }) => {
    const free = document?.constraints.some(({ enabled }) => enabled) ? document.free : 0;
    if (free === reported) return;
    reported = free;
    clear();
    if (free === 0) return;
    const request = {
      operation: 'free',
      mode: /** @type {const} */ ('vertices'),
      from: {},
      params: {},
    };
    const found = await actions.reportErrors(actions.find(request));
    if (!found || store.get().model !== model || reported !== free) return;
    tint = { vertices: found.vertices, faces: new Uint32Array(0), colour: COLOUR };
    actions.tint(tint);
    place.replaceChildren(message(free, [...found.vertices]));
  });
  // Pointing at a constraint replaces the tint.
  store.subscribe(['tint'], (now) => {
    if (tint && !now.tint) actions.tint(tint);
  });

  /**
   * @param {number} free
   * @param {number[]} vertices
   */
  function message(free, vertices) {
    const stand =
      free === 1
        ? 'vertex stands still: nothing acts on it.'
        : 'vertices stand still: nothing acts on them.';
    return element(
      'div.message.notice',
      { role: 'group', 'aria-label': 'Vertices that stand still' },
      element('p', `${count(free, stand, stand)}`),
      button('Let them follow', () => actions.edit({ type: 'preset', id: 'opened' }), SMALL),
      button('Fix them', () => actions.addHandles(vertices, true), SMALL),
      button('Select', () => actions.select({ vertices, faces: [] }), SMALL),
      closeButton('Close', clear),
    );
  }
}
