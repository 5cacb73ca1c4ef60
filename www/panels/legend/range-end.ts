/** One end of the colour range on the ramp of the legend, moved by dragging or keys. */

import { element } from '../../ui/dom.ts';
import { followTrack, placeOnTrack } from '../../ui/controls/track.ts';
import { positionOf, valueAt, type Axis } from '../../ui/plot/value-axis.ts';
import type { Actions } from '../../store/actions.ts';

/** The step of an arrow key, relative to the axis. */
const STEP = 0.02;
/** The least distance between the ends, relative to the axis. */
const APART = 0.01;

/** @returns an end that follows the other one is hidden */
export function rangeEnd(
  end: 'low' | 'high',
  ramp: HTMLElement,
  actions: Actions,
): { show: (axis: Axis, range: [number, number], words: string, follows: boolean) => void } {
  const isLow = end === 'low';
  const handle = element('div.range-end', {
    role: 'slider',
    tabindex: 0,
    title: 'Drag to change the range of the colours; double-click for the automatic one',
    'aria-label': isLow ? 'Low end of the range' : 'High end of the range',
  });
  ramp.append(handle);

  /** The axis and range of the ramp. */
  let shown: { axis: Axis; range: [number, number] } | null = null;

  followTrack(handle, {
    track: () => ramp,
    at: () => shown && positionOf(shown.axis, shown.range[isLow ? 0 : 1]),
    moveTo(place) {
      if (!shown) return;
      const { axis, range } = shown;
      const other = positionOf(axis, range[isLow ? 1 : 0]);
      const value = isLow
        ? Math.max(0, Math.min(place, other - APART))
        : Math.min(1, Math.max(place, other + APART));
      // Keeps the axis fixed while an end moves.
      actions.setRange({ [end]: valueAt(axis, value), top: axis.high });
    },
    reset: () => actions.setRange({ [end]: null }),
    step: STEP,
  });

  return {
    show(axis, range, words, follows) {
      handle.hidden = follows;
      shown = { axis, range };
      placeOnTrack(handle, positionOf(axis, range[isLow ? 0 : 1]), words);
    },
  };
}
