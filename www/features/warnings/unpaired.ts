/**
 * Reports how many vertices of a constraint on pairs, such as a symmetry, have a partner. The
 * others are free; if none has one, the constraint does nothing.
 */

import { closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import type { AppContext } from '../../app/context.ts';

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
