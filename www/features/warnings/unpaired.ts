/**
 * Reports how many vertices of a constraint on pairs, such as a symmetry, have a partner. The
 * others are free; if none has one, the constraint does nothing.
 */

import { closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { groupDigits } from '../../ui/format.ts';
import type { AppContext } from '../../app/context.ts';
import type { ConstraintRow } from '../../solver/types.ts';

export function watchUnpaired({ store }: AppContext) {
  const place = element('div', { 'aria-live': 'polite' });
  document.getElementById('messages')?.append(place);
  /** The last message, also if it was closed. */
  let said = '';

  store.subscribe(['document'], (state) => {
    const words = (state.document?.constraints ?? []).filter(isPartly).map(sentence);
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

const isPartly = ({ enabled, paired }: ConstraintRow) =>
  enabled && paired && paired.vertices < paired.of;

function sentence({ label, on, paired }: ConstraintRow) {
  const { vertices = 0, of = 0 } = paired ?? {};
  const what = `${label} on ${on}`;
  const all = groupDigits(of);
  return vertices === 0
    ? `${what}: none of the ${all} vertices has an image among the others, so it does nothing. Check the direction of its mirror or axis.`
    : `${what}: ${groupDigits(vertices)} of ${all} vertices have an image; the others are free.`;
}
