/**
 * Reports vertices on which a constraint does not act: those that none acts on, which stay in place
 * while the rest moves, and those of a constraint on pairs, such as a symmetry, that have no partner.
 */

import { newestOnly } from '../../store/newest-only.ts';
import { button, closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import type { AppContext } from '../../app/context.ts';
import type { Tint } from '../../store/state.ts';

/** The colour of their dots, sRGB bytes. */
const COLOUR: [number, number, number] = [214, 132, 24];
const SMALL = { class: 'small bordered' };

/** Marks vertices that no constraint acts on, and offers to let them follow or to fix them. */
export function watchFreeVertices({ store, actions }: AppContext) {
  const place = element('div', { 'aria-live': 'polite' });
  document.getElementById('messages')?.append(place);
  /** The tint of the free vertices. */
  let tint: Tint | null = null;
  /** Number of free vertices in the last message, also if it was closed. */
  let reported = 0;
  const newest = newestOnly(() => store.get().model);

  function clear() {
    place.replaceChildren();
    if (store.get().tint === tint) actions.tint(null);
    tint = null;
  }

  store.subscribe(['document'], async ({ document }) => {
    const free = document?.constraints.some(({ enabled }) => enabled) ? document.free : 0;
    if (free === reported) return;
    reported = free;
    clear();
    const request = {
      operation: 'free',
      mode: 'vertices' as const,
      from: {},
      params: {},
    };
    const asked = free > 0 ? actions.reportErrors(actions.ask.select(request)) : null;
    const found = await newest(asked);
    if (!found) return;
    tint = { vertices: found.vertices, faces: new Uint32Array(0), colour: COLOUR };
    actions.tint(tint);
    place.replaceChildren(message(free, [...found.vertices]));
  });
  // Pointing at a constraint replaces the tint.
  store.subscribe(['tint'], (now) => {
    if (tint && !now.tint) actions.tint(tint);
  });

  function message(free: number, vertices: number[]) {
    const stand =
      free === 1
        ? 'vertex stands still: nothing acts on it.'
        : 'vertices stand still: nothing acts on them.';
    return element(
      'div.message.notice',
      { role: 'group', 'aria-label': 'Vertices that stand still' },
      element('p', `${count(free, stand, stand)}`),
      button('Let them follow', () => actions.edit({ preset: { id: 'opened' } }), SMALL),
      button('Fix them', () => actions.addHandles(vertices, true), SMALL),
      button('Select', () => actions.select({ vertices, faces: [] }), SMALL),
      closeButton('Close', clear),
    );
  }
}

/** Reports how many vertices have no partner. They are free; if none has one, the constraint does nothing. */
export function watchUnpaired({ store }: AppContext) {
  const place = element('div', { 'aria-live': 'polite' });
  document.getElementById('messages')?.append(place);
  /** The last message, also if it was closed. */
  let said = '';

  store.subscribe(['document'], (state) => {
    const words = state.document?.unpaired ?? [];
    if (words.join() === said) return;
    said = words.join();
    place.replaceChildren(
      ...(words.length > 0
        ? [
            element(
              'div.message.notice',
              { role: 'group', 'aria-label': 'Vertices without an image' },
              element('p', words.join(' ')),
              closeButton('Close', () => place.replaceChildren()),
            ),
          ]
        : []),
    );
  });
}
