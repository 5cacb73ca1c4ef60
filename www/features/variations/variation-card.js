/** The card of a variation: a thumbnail of the deformed shape, and a slider. */

import { element, setText } from '../../ui/dom.js';
import { drawShape } from '../../ui/plot/thumbnail.js';

/** Slider position shown in the thumbnail, as a fraction of half the slider's length. */
const PICTURED = 0.6;
/** Slider steps from the middle to either end. */
const STEPS = 100;

/**
 * @param {number} index
 * @param {number} slide maximum absolute value of the coefficient
 * @param {() => void} change while the slider moves
 * @param {() => void} release when the slider is released
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
    // Double click resets, as is usual.
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
     * @param {Float32Array} displacements per unit of the coefficient, `#V by 3`
     * @param {"y" | "z"} up
     */
    draw(connectivity, shape, displacements, up) {
      const changed = shape.map((at, i) => at + PICTURED * slide * displacements[i]);
      drawShape(canvas, connectivity, changed, { up, displacements });
    },
    /** Marks the feasible range of the slider, if known. @param {number[] | null} range */
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
