/**
 * One end of the colour range on the ramp of the legend: moved by dragging or keys, automatic again
 * after a double click.
 */

import { useRef } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import type { RefObject } from 'preact';
import type { Spread } from '../../store/colours/spread.ts';

/** The step of an arrow key, relative to the axis. */
const STEP = 0.02;
/** The step of the page keys, and of an arrow with Shift. */
const LARGE = 0.1;
const ARROWS: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
const JUMPS: Record<string, number> = { PageUp: LARGE, PageDown: -LARGE, Home: -1, End: 1 };
const RESET = ['Delete', 'Backspace'];
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
  const { end, ramp, words, signed } = props;
  const { places, axis } = props.spread;
  const { viewport, actions } = useApp();
  /** Offset from the pointer to the centre of the handle during a drag, in pixels. */
  const grabbed = useRef<number | null>(null);
  const place = places[end];
  const reset = () => actions.setRange({ [end]: null });

  /** @param to relative to the axis */
  function moveTo(to: number) {
    if (!viewport.view) return;
    const part =
      end === 'low'
        ? Math.max(0, Math.min(to, places.high - APART))
        : Math.min(1, Math.max(to, (signed ? MIDDLE : places.low) + APART));
    const value = viewport.view.valueOnAxis(axis.low, axis.high, axis.log, part);
    // Keeps the axis fixed while an end moves.
    actions.setRange({ [end]: value, top: axis.high });
  }

  function press(event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const by = JUMPS[event.key] ?? ARROWS[event.key] * (event.shiftKey ? LARGE : STEP);
    if (by) moveTo(place + by);
    else if (RESET.includes(event.key)) reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  return (
    <div
      class="range-end"
      role="slider"
      tabIndex={0}
      title="Drag to change the range of the colours; double-click for the automatic one"
      aria-label={end === 'low' ? 'Low end of the range' : 'High end of the range'}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(100 * place)}
      aria-valuetext={words}
      style={{ left: `${100 * place}%` }}
      hidden={signed && end === 'low'}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        const { currentTarget: handle, clientX, pointerId } = event;
        const { left, width } = handle.getBoundingClientRect();
        grabbed.current = left + width / 2 - clientX;
        handle.setPointerCapture(pointerId);
        handle.focus({ preventScroll: true });
        event.preventDefault();
      }}
      onPointerMove={({ clientX }) => {
        const box = ramp.current?.getBoundingClientRect();
        if (grabbed.current === null || !box) return;
        moveTo((clientX + grabbed.current - box.left) / box.width);
      }}
      onLostPointerCapture={() => (grabbed.current = null)}
      onDblClick={reset}
      onKeyDown={press}
    />
  );
}
