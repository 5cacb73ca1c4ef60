/** One end of the colour range on the ramp of the legend, moved by dragging or keys. */

import { useEffect, useRef } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { followTrack } from '../../ui/controls/track.ts';
import type { RefObject } from 'preact';
import type { Spread } from '../../store/colours/spread.ts';

/** The step of an arrow key, relative to the axis. */
const STEP = 0.02;
/** The least distance between the ends, relative to the axis. */
const APART = 0.01;
/** Where a symmetric axis has 0. */
const MIDDLE = 0.5;

export function RangeEnd(props: {
  end: 'low' | 'high';
  ramp: RefObject<Element | null>;
  spread: Spread;
  /** its value */
  words: string;
  /** whether the range is symmetric: the low end follows the high one, and is hidden */
  signed: boolean;
}) {
  const { end, ramp, spread, words, signed } = props;
  const { viewport, actions } = useApp();
  const handle = useRef<HTMLDivElement>(null);
  const shown = useRef(spread);
  shown.current = spread;
  const place = 100 * spread.places[end];

  function moveTo(place: number) {
    if (!viewport.view) return;
    const { places, axis } = shown.current;
    const part =
      end === 'low'
        ? Math.max(0, Math.min(place, places.high - APART))
        : Math.min(1, Math.max(place, (signed ? MIDDLE : places.low) + APART));
    const value = viewport.view.valueOnAxis(axis.low, axis.high, axis.log, part);
    // Keeps the axis fixed while an end moves.
    actions.setRange({ [end]: value, top: axis.high });
  }

  useEffect(() => {
    if (!handle.current) return;
    followTrack(handle.current, {
      track: () => ramp.current,
      at: () => shown.current.places[end],
      moveTo,
      reset: () => actions.setRange({ [end]: null }),
      step: STEP,
    });
  }, []);

  return (
    <div
      ref={handle}
      class="range-end"
      role="slider"
      tabIndex={0}
      title="Drag to change the range of the colours; double-click for the automatic one"
      aria-label={end === 'low' ? 'Low end of the range' : 'High end of the range'}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(place)}
      aria-valuetext={words}
      style={{ left: `${place}%` }}
      hidden={signed && end === 'low'}
    />
  );
}
