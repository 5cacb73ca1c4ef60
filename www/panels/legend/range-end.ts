/** One end of the colour range on the ramp of the legend, moved by dragging or keys. */

import { element } from '../../ui/dom.ts';
import { followTrack, placeOnTrack } from '../../ui/controls/track.ts';
import type { AppContext } from '../../app/context.ts';
import type { Spread } from '../../store/colours/spread.ts';

/** The step of an arrow key, relative to the axis. */
const STEP = 0.02;
/** The least distance between the ends, relative to the axis. */
const APART = 0.01;

/** @returns an end that follows the other one is hidden */
export function rangeEnd(
  end: 'low' | 'high',
  ramp: HTMLElement,
  { viewport, actions }: AppContext,
): { show: (spread: Spread, words: string, follows: boolean) => void } {
  const isLow = end === 'low';
  const handle = element('div.range-end', {
    role: 'slider',
    tabindex: 0,
    title: 'Drag to change the range of the colours; double-click for the automatic one',
    'aria-label': isLow ? 'Low end of the range' : 'High end of the range',
  });
  ramp.append(handle);

  let shown: Spread | null = null;

  followTrack(handle, {
    track: () => ramp,
    at: () => shown && shown.places[end],
    moveTo(place) {
      if (!shown || !viewport.view) return;
      const { places, axis } = shown;
      const part = isLow
        ? Math.max(0, Math.min(place, places.high - APART))
        : Math.min(1, Math.max(place, places.low + APART));
      const value = viewport.view.valueOnAxis(axis.low, axis.high, axis.log, part);
      // Keeps the axis fixed while an end moves.
      actions.setRange({ [end]: value, top: axis.high });
    },
    reset: () => actions.setRange({ [end]: null }),
    step: STEP,
  });

  return {
    show(spread, words, follows) {
      handle.hidden = follows;
      shown = spread;
      placeOnTrack(handle, spread.places[end], words);
    },
  };
}
