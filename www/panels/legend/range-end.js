/** An end of the range of the colours on the ramp of the legend: dragged, or moved by keys. */

import { element, setAttribute } from '../../ui/dom.js';
import { placeOn, valueAt } from '../../ui/plot/value-axis.js';

/** @typedef {import("../../ui/plot/value-axis.js").Axis} Axis */

/** A step of a key, of the axis; with Shift so many times as far. */
const STEP = 0.02;
const LARGE = 5;
/** The ends stay so far apart, of the axis. */
const APART = 0.01;

/** @type {Record<string, (at: number, step: number) => number>} */
const KEYS = {
  ArrowRight: (at, step) => at + step,
  ArrowUp: (at, step) => at + step,
  ArrowLeft: (at, step) => at - step,
  ArrowDown: (at, step) => at - step,
  Home: () => 0,
  End: () => 1,
};

/**
 * @param {"low" | "high"} end
 * @param {HTMLElement} ramp
 * @param {import("../../store/actions.js").Actions} actions
 * @returns {{ show: (axis: Axis, range: [number, number], words: string) => void }}
 */
export function rangeEnd(end, ramp, actions) {
  const isLow = end === 'low';
  const handle = element('div.range-end', {
    role: 'slider',
    tabindex: 0,
    title: 'Drag to change the range of the colours; double-click for the automatic one',
    'aria-label': isLow ? 'Low end of the range' : 'High end of the range',
  });
  ramp.append(handle);

  /** What the ramp shows. @type {{ axis: Axis, range: [number, number] } | null} */
  let shown = null;

  /** @param {number} place from 0 to 1 on the axis */
  function moveTo(place) {
    if (!shown) return;
    const { axis, range } = shown;
    const other = placeOn(axis, range[isLow ? 1 : 0]);
    const [least, most] = isLow ? [0, other - APART] : [other + APART, 1];
    const value = valueAt(axis, Math.min(Math.max(place, least), most));
    // The axis stays while something moves on it.
    actions.setRange({ [end]: value, top: axis.high });
  }

  const reset = () => actions.setRange({ [end]: null });

  handle.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    handle.focus();
    handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener('pointermove', (event) => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const { left, width } = ramp.getBoundingClientRect();
    moveTo((event.clientX - left) / width);
  });
  handle.addEventListener('dblclick', reset);
  handle.addEventListener('keydown', (event) => {
    if (!shown) return;
    const key = KEYS[event.key];
    const at = placeOn(shown.axis, shown.range[isLow ? 0 : 1]);
    if (key) moveTo(key(at, event.shiftKey ? LARGE * STEP : STEP));
    else if (event.key === 'Delete' || event.key === 'Backspace') reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  return {
    show(axis, range, words) {
      shown = { axis, range };
      const place = placeOn(axis, range[isLow ? 0 : 1]);
      handle.style.left = `${100 * place}%`;
      setAttribute(handle, 'aria-valuemin', '0');
      setAttribute(handle, 'aria-valuemax', '100');
      setAttribute(handle, 'aria-valuenow', String(Math.round(100 * place)));
      setAttribute(handle, 'aria-valuetext', words);
    },
  };
}
