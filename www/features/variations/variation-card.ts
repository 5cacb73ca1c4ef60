/** The card of a variation: a thumbnail of the deformed shape, and a slider. */

import { element, setText } from '../../ui/dom.ts';
import { drawShape } from '../../ui/plot/thumbnail.ts';
import type { Connectivity } from '../../solver/types.ts';

/** Slider position shown in the thumbnail, as a fraction of half the slider's length. */
const PICTURED = 0.6;
/** Slider steps from the middle to either end. */
const STEPS = 100;

/**
 * @param slide maximum absolute value of the coefficient
 * @param change while the slider moves
 * @param release when the slider is released
 */
export function variationCard(
  index: number,
  slide: number,
  change: () => void,
  release: () => void,
) {
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

  function set(coefficient: number) {
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
     * @param shape `#V by 3`
     * @param displacements per unit of the coefficient, `#V by 3`
     */
    draw(
      connectivity: Connectivity,
      shape: Float64Array,
      displacements: Float32Array,
      up: 'y' | 'z',
    ) {
      const changed = shape.map((at, i) => at + PICTURED * slide * displacements[i]);
      drawShape(canvas, connectivity, changed, { up, displacements });
    },
    /** Marks the feasible range of the slider, if known. */
    showRange(range: number[] | null) {
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
