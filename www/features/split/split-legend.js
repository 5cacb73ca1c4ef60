/**
 * The legend of one of the two pictures: selectors for its shape and measure, and the histogram of
 * its face values with the histogram of the original as an outline.
 */

import { rampOf } from '../../viewport/ramp.js';
import { setOptions } from '../../ui/controls/fields.js';
import { element, setText } from '../../ui/dom.js';
import { groupDigits } from '../../ui/format.js';
import {
  declared,
  movedInWords,
  toleranceOf,
  unitOf,
  valueInWords,
} from '../../store/colours/measures.js';
import { bars, drawBars, drawOutline, outline } from '../../ui/plot/histogram-svg.js';
import { countsOf, greatestOf } from '../../ui/plot/histogram.js';
import { axisOf, positionOf } from '../../ui/plot/value-axis.js';

/** @typedef {import("../../store/view-modes.js").Choice} Choice */

/** The value of the option for a kept shape. */
const KEPT = 'kept';

export class SplitLegend {
  #side;
  #store;
  #viewport;
  #measure;
  #shape;
  #bars = bars();
  #before = outline();
  #histogram = element('div.histogram', { role: 'img' }, this.#bars, this.#before);
  #ramp = element('div.ramp');
  #steps = element('span.quiet');
  #least = element('span');
  #top = element('span');
  #facts = element('p.facts-line');
  element;

  /**
   * @param {string} name of the side
   * @param {number} side 0 left, 1 right
   * @param {import("../../store/state.js").Store} store
   * @param {import("../../viewport/viewport.js").Viewport} viewport
   * @param {(choice: Partial<Choice>) => void} choose
   */
  constructor(name, side, store, viewport, choose) {
    this.#side = side;
    this.#store = store;
    this.#viewport = viewport;
    this.#measure = element('select', {
      'aria-label': `${name}: coloured by`,
      onchange: () => choose({ measure: this.#measure.value }),
    });
    this.#shape = element('select', {
      'aria-label': `${name}: shape`,
      onchange: () => choose({ original: this.#shape.value === 'original', variant: undefined }),
    });
    this.element = element(
      'div',
      {
        class: `card split-legend ${name.toLowerCase()}`,
        role: 'group',
        'aria-label': `${name} picture`,
      },
      element('div.choices', this.#shape, this.#measure),
      this.#histogram,
      this.#ramp,
      element('div.ends.figure', this.#least, this.#steps, this.#top),
      this.#facts,
    );
  }

  /**
   * @param {(Choice & import("../../store/view-modes.js").Shown) | undefined} side
   * @param {Float32Array | undefined} original values of the original in the same measure
   */
  show(side, original) {
    this.element.hidden = !side;
    const state = this.#store.get();
    const about = side && declared(state, side.measure);
    if (!side?.values || !about) return;
    if (this.#measure.options.length !== state.measures.length) {
      this.#measure.replaceChildren(
        ...state.measures.map(({ id, label }) => element('option', { value: id }, label)),
      );
    }
    this.#measure.value = about.id;
    this.#measure.title = about.words;
    const kept = side.variant ? [[KEPT, side.variant.name]] : [];
    setOptions(this.#shape, [['original', 'Original'], ['now', 'Now'], ...kept]);
    this.#shape.value = side.variant ? KEPT : side.original ? 'original' : 'now';

    const axis = axisOf(about.signed ? -side.top : 0, side.top, false);
    drawBars(this.#bars, countsOf(side.values, axis));
    const before = side.original || !original ? null : countsOf(original, axis);
    drawOutline(this.#before, before, Math.max(...(before ?? [])));
    const from = about.signed ? 0 : 100 * positionOf(axis, side.tolerance ?? 0);
    const ends = /** @type {[number, number]} */ ([from, 100]);
    this.#ramp.style.background = rampOf(this.#viewport, ends, {
      side: this.#side,
      neutral: from,
    });

    const units = state.document?.units ?? '';
    const step = this.#viewport.with((view) => view.bandStep(this.#side));
    const like = toleranceOf(state, about);
    const written = unitOf(about, like ?? side.top, units);
    setText(this.#steps, step ? `steps of ${Number((step * written.factor).toPrecision(3))}` : '');
    const words = (/** @type {number} */ value) => valueInWords(about, value, units, like);
    const { mean, faces } = meanOf(side.values);
    const worst = words(greatestOf(side.values));
    setText(this.#least, about.signed ? words(-side.top) : '0');
    setText(this.#top, words(side.top));
    const moved = side.original || side.variant ? '' : movedInWords(state);
    setText(this.#facts, `mean ${words(mean)}, worst ${worst}${moved && ` · moved ${moved}`}`);
    const outlined = before && original ? `; originally up to ${words(greatestOf(original))}` : '';
    this.#histogram.ariaLabel = `${groupDigits(faces)} faces between ${about.signed ? words(-greatestOf(side.values)) : 0} and ${worst}${outlined}`;
    this.#histogram.title = before ? 'Outline: the original' : '';
  }
}

/** Mean and number of values that are not NaN. @param {Float32Array} values */
function meanOf(values) {
  const known = values.filter((value) => !Number.isNaN(value));
  const sum = known.reduce((total, value) => total + value, 0);
  return { mean: known.length > 0 ? sum / known.length : 0, faces: known.length };
}
