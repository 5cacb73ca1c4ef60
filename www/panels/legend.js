/**
 * The legend of the faces' colours: a histogram of their values over the ramp, the ends of the
 * range, and how many faces are within a tolerance.
 */

import { element, setAttribute, setText } from '../dom.js';
import { groupDigits, number } from '../format.js';
import { declared, unitOf, valueInWords } from '../measures.js';
import { bars, drawBars, drawOutline, outline } from '../outline.js';
import { isDrawn } from '../state.js';

/**
 * @param {HTMLElement} place
 * @param {import("../state.js").Store} store
 * @param {import("../viewport.js").Viewport} viewport
 * @param {() => void} refit
 */
export function legend(place, store, viewport, refit) {
  const title = element('span');
  const now = bars();
  const before = outline();
  const histogram = element(
    'div',
    { class: 'histogram', role: 'img', 'aria-label': 'No values yet' },
    now,
    before,
  );
  const tick = element('div', { class: 'tick' });
  const ramp = element('div', { class: 'ramp' }, tick);
  const unit = element('span', { class: 'unit' });
  const toleranceUnit = element('span');
  const within = element('span', { class: 'within', title: 'Faces within the tolerance' });
  const low = field('Colours from', ([, high], value) => [Math.min(value, high), high]);
  const high = field('Colours to', ([low], value) => [Math.min(low, value), value]);
  const tolerance = element('input', {
    type: 'text',
    inputMode: 'decimal',
    'aria-label': 'Tolerance',
    placeholder: 'none',
    onchange: () => {
      const value = Number.parseFloat(tolerance.value.replace(',', '.'));
      store.set({ tolerance: value >= 0 ? value / fineUnit().factor : null });
    },
    onblur: () => show(),
  });
  place.replaceChildren(
    element(
      'div',
      { class: 'title' },
      title,
      element(
        'button',
        {
          type: 'button',
          title: 'Take the range of the colours from the shape as it is',
          onclick: refit,
        },
        'Refit colours',
      ),
    ),
    histogram,
    ramp,
    element('div', { class: 'ends' }, low, unit, high),
    element(
      'div',
      { class: 'ends' },
      element('label', {}, 'tolerance', tolerance, toleranceUnit),
      within,
    ),
  );

  /** From the measure's unit to the one in which its values are written. */
  function factor() {
    const { spread, document } = store.get();
    const about = declared(store.get(), spread?.measure ?? null);
    return about && spread ? unitOf(about, spread.top, document?.units ?? '').factor : 1;
  }

  /** What is small enough to be a tolerance is written in it. */
  function fineUnit() {
    const about = declared(store.get(), store.get().measure);
    const units = store.get().document?.units ?? '';
    return about ? unitOf(about, 0, units) : { unit: '', factor: 1 };
  }

  /**
   * An end of the range.
   * @param {string} name
   * @param {(range: [number, number], value: number) => [number, number]} change
   */
  function field(name, change) {
    const input = element('input', {
      type: 'text',
      inputMode: 'decimal',
      'aria-label': name,
      onchange: () => {
        const value = Number.parseFloat(input.value.replace(',', '.'));
        if (value >= 0) store.set({ range: change(store.get().range, value / factor()) });
      },
      onblur: () => show(),
    });
    return input;
  }

  function show() {
    const state = store.get();
    const { measure, range, spread, document, model, flatMap, split } = state;
    const about = declared(state, measure);
    // A flat map has colours and a legend of its own, and so have two pictures.
    const isShown = about && !flatMap && !split && model?.faces;
    place.hidden = !isShown || !isDrawn(state);
    if (!about || place.hidden) return;
    setText(title, about.label);
    setAttribute(title, 'title', about.words);
    if (!spread) return;
    const units = document?.units ?? '';
    const written = unitOf(about, spread.top, units);
    const step = viewport.unmeasured((view) => view.bandStep());
    const steps = step && `steps of ${Number((step * written.factor).toPrecision(3))} `;
    setText(unit, `${steps ?? ''}${written.unit}`);
    const fine = fineUnit();
    setText(toleranceUnit, fine.unit);
    for (const [input, value, factor] of /** @type {const} */ ([
      [low, range[0], written.factor],
      [high, range[1], written.factor],
      [tolerance, state.tolerance, fine.factor],
    ])) {
      if (input === globalThis.document.activeElement) continue;
      const text = value === null ? '' : number(value * factor);
      if (input.value !== text) input.value = text;
    }

    const [from, to] = range.map((value) => (100 * value) / spread.top);
    ramp.style.background = viewport.rampOf([from, to]);
    drawBars(now, spread.counts);
    tick.hidden = state.tolerance === null || state.tolerance > spread.top;
    if (state.tolerance !== null) tick.style.left = `${(100 * state.tolerance) / spread.top}%`;

    const worst = valueInWords(about, spread.greatest, units);
    const was = spread.original && valueInWords(about, spread.original.greatest, units);
    const compared = was === null ? '' : `; originally up to ${was}`;
    const words = `${groupDigits(spread.faces)} faces between 0 and ${worst}${compared}`;
    setAttribute(histogram, 'aria-label', words);
    // Each is drawn to its own highest bar: it is how they are spread that is compared.
    drawOutline(
      before,
      spread.original?.counts ?? null,
      Math.max(...(spread.original?.counts ?? [])),
    );
    setAttribute(histogram, 'title', was === null ? '' : `Outline: the original, up to ${was}`);
    setText(
      within,
      state.tolerance === null
        ? ''
        : `${groupDigits(spread.within)} of ${groupDigits(spread.faces)}`,
    );
  }
  store.subscribe(
    [
      'measure',
      'measures',
      'range',
      'spread',
      'tolerance',
      'document',
      'renderer',
      'model',
      'dark',
      'flatMap',
      'split',
      'display',
    ],
    show,
  );
}
