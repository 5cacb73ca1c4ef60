/** The divider between the two pictures, moved by dragging or with keys. */

import { element } from '../../ui/dom.ts';
import { followTrack, placeOnTrack } from '../../ui/controls/track.ts';
import type { AppContext } from '../../app/context.ts';

/** @param words for the left and right picture */
export function splitDivider({ store, actions }: AppContext, words: () => string[] | undefined) {
  const divider = element(
    'div.split-divider',
    {
      ...{ role: 'slider', tabindex: '0' },
      ...{ 'aria-label': 'Divider', 'aria-orientation': 'horizontal' },
    },
    element('span.knob'),
  );
  const moveTo = (at: number) => {
    const { split } = store.get();
    if (split) actions.look({ split: { ...split, at } });
  };
  followTrack(divider, {
    track: () => divider.offsetParent,
    at: () => store.get().split?.at ?? null,
    moveTo,
    reset: () => moveTo(0.5),
    step: 0.01,
  });
  store.subscribe(['split'], ({ split }) => {
    divider.hidden = !split;
    if (!split) return;
    const [left, right] = words() ?? [];
    const percent = Math.round(100 * split.at);
    placeOnTrack(divider, split.at, `${percent} %; left ${left}; right ${right}`);
  });
  return divider;
}
