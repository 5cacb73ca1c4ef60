/** A way to change the shape: its picture, and the slider that goes along it. */

import { element, setText } from '../../ui/dom.js';
import { drawShape } from '../../ui/plot/thumbnail.js';

/** Of the way from the middle to the end of the slider, in the picture. */
const PICTURED = 0.6;
/** Steps of the slider from the middle to either end. */
const STEPS = 100;

/**
 * @param {number} index
 * @param {number} slide coefficients go so far to either side
 * @param {() => void} change while it moves
 * @param {() => void} release when it is let go
 */
export function variationCard(index, slide, change, release) {
  const name = `Variation ${index + 1}`;
  const canvas = element('canvas', { 'aria-hidden': 'true' });
  const figure = element('span.figure');
  const slider = element('input', {
    ...{ type: 'range', min: -STEPS, max: STEPS, value: 0, 'aria-label': name },
    oninput: () => {
      say();
      change();
    },
    onchange: release,
    // As in other programs.
    ondblclick: () => {
      set(0);
      release();
    },
  });
  const place = element(
    'div.variation-card',
    canvas,
    element('div.heading-row', element('span', String(index + 1)), figure),
    slider,
  );
  const value = () => (slide * slider.valueAsNumber) / STEPS;

  /** @param {number} coefficient */
  function set(coefficient) {
    slider.valueAsNumber = Math.round((coefficient / slide) * STEPS);
    say();
  }

  function say() {
    const percent = 100 * value();
    const words = `${percent > 0 ? '+' : ''}${percent.toFixed(1).replace('-', '−')} %`;
    setText(figure, percent === 0 ? '' : words);
    slider.ariaValueText = `${words} of the size`;
  }

  return {
    place,
    value,
    set,
    /**
     * @param {import("../../solver/messages.js").Connectivity} connectivity
     * @param {Float64Array} shape `#V by 3`
     * @param {Float32Array} ways `#V by 3`
     * @param {"y" | "z"} up
     */
    draw(connectivity, shape, ways, up) {
      const changed = shape.map((at, i) => at + PICTURED * slide * ways[i]);
      drawShape(canvas, connectivity, changed, { up, ways });
    },
    /** Marks what is possible, where it is known. @param {number[] | null} range */
    showRange(range) {
      const known = range?.every(Number.isFinite);
      place.toggleAttribute('data-known', Boolean(known));
      if (!range || !known) return;
      const [from, to] = range.map((end) => `${50 + (50 * end) / slide}%`);
      place.style.setProperty('--from', from);
      place.style.setProperty('--to', to);
      const words = range.map((end) => `${(100 * end).toFixed(1).replace('-', '−')} %`);
      slider.title = `Possible from ${words.join(' to ')} of the size`;
    },
  };
}
