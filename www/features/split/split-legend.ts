/**
 * The legend of one of the two pictures: selectors for its shape and measure, and the histogram of
 * its face values with the histogram of the original as an outline.
 */

import { rampOf } from '../../viewport/ramp.ts';
import { setOptions } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { groupDigits } from '../../ui/format.ts';
import {
  declared,
  movedInWords,
  toleranceOf,
  unitOf,
  valueInWords,
} from '../../store/colours/measures.ts';
import { bars, drawBars, drawOutline, outline } from '../../ui/plot/histogram-svg.ts';
import { countsOf, greatestOf } from '../../ui/plot/histogram.ts';
import { axisOf, positionOf } from '../../ui/plot/value-axis.ts';
import type { Choice, Shown } from '../../store/view-modes.ts';
import type { Store } from '../../store/state.ts';
import type { Viewport } from '../../viewport/viewport.ts';

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
   * @param name of the side
   * @param side 0 left, 1 right
   */
  constructor(
    name: string,
    side: number,
    store: Store,
    viewport: Viewport,
    choose: (choice: Partial<Choice>) => void,
  ) {
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

  /** @param original values of the original in the same measure */
  show(side: (Choice & Shown) | undefined, original: Float32Array | undefined) {
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
    const ends = [from, 100] as [number, number];
    this.#ramp.style.background = rampOf(this.#viewport, ends, {
      side: this.#side,
      neutral: from,
    });

    const units = state.document?.units ?? '';
    const step = this.#viewport.with((view) => view.bandStep(this.#side));
    const like = toleranceOf(state, about);
    const written = unitOf(about, like ?? side.top, units);
    setText(this.#steps, step ? `steps of ${Number((step * written.factor).toPrecision(3))}` : '');
    const words = (value: number) => valueInWords(about, value, units, like);
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

/** Mean and number of values that are not NaN. */
function meanOf(values: Float32Array) {
  const known = values.filter((value) => !Number.isNaN(value));
  const sum = known.reduce((total, value) => total + value, 0);
  return { mean: known.length > 0 ? sum / known.length : 0, faces: known.length };
}
