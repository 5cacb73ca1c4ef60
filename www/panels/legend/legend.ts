/**
 * The legend of the face colours: a histogram of their values over the colour ramp, the ends of the
 * range, the number of faces within the tolerance, and the displacement of the mesh.
 */

import { cover } from '../../viewport/camera.ts';
import { rampOf } from '../../viewport/ramp.ts';
import { checkbox, choice, setOptions } from '../../ui/controls/fields.ts';
import { element, setAttribute, setText } from '../../ui/dom.ts';
import { isEmbedded } from '../../ui/embedded.ts';
import { groupDigits, number, round } from '../../ui/format.ts';
import {
  declared,
  movedInWords,
  toleranceOf,
  unitOf,
  valueInWords,
} from '../../store/colours/measures.ts';
import { bars, drawBars, drawOutline, outline } from '../../ui/plot/histogram-svg.ts';
import { isDrawn, type State } from '../../store/state.ts';
import { rangeEnd } from './range-end.ts';
import type { AppContext } from '../../app/context.ts';

/** The option that colours only values beyond the tolerance. */
const BEYOND = 'beyond';
/** Id, label and tooltip of each colour map. */
const MAPS: [string, string, string][] = [
  [BEYOND, 'Beyond tolerance', 'Only faces beyond the tolerance are coloured'],
  ['viridis', 'Viridis', 'All faces are coloured'],
  ['diverging', 'Diverging', 'Blue within the tolerance, red beyond it'],
  ['grey', 'Grey', 'All faces in shades of grey, for print'],
];

/** On a phone in landscape orientation the legend is a strip below the model. */
const strip = matchMedia('(min-width: 700px) and (max-height: 480px)');

export function legend(place: HTMLElement, app: AppContext, fit: () => void) {
  const { store, viewport, actions } = app;
  const title = element('span');
  const now = bars();
  const before = outline();
  const histogram = element(
    'div.histogram',
    { role: 'img', 'aria-label': 'No values yet' },
    now,
    before,
  );
  const tick = element('div.tick');
  const ramp = element('div.ramp', tick);
  const ends = [rangeEnd('low', ramp, app), rangeEnd('high', ramp, app)];
  const unit = element('span.unit');
  const toleranceUnit = element('span');
  const within = element('span.within', { title: 'Faces within the tolerance' });
  const facts = element('p.quiet.facts');
  const low = field('Colours from', (low) => actions.setRange({ low }));
  const high = field('Colours to', (high) => actions.setRange({ high }));
  const tolerance = field('Tolerance', (value) => {
    const state = store.get();
    const about = declared(state, state.measure);
    if (about?.toleranced) void actions.edit({ setTolerance: { tolerance: value } });
    else if (about) actions.setToleranceOf(about.id, value);
  });
  tolerance.placeholder = 'none';
  const log = checkbox('Log scale', (checked) => actions.display({ log: checked }), {
    title: 'Equal ratios have equal lengths on the scale',
  });
  const map = choice({ 'aria-label': 'Colour map' }, (name) =>
    actions.display(
      name === BEYOND ? { full: false } : { full: true, map: name as State['display']['map'] },
    ),
  );
  place.replaceChildren(
    element(
      'div.title',
      title,
      element(
        'button',
        { title: 'End the range at the worst face of the current shape', onclick: fit },
        'Fit range',
      ),
    ),
    histogram,
    ramp,
    element('div.ends', low, unit, high),
    element('div.ends', element('label', 'Tolerance', tolerance, toleranceUnit), within),
    facts,
    element('div.ends.switches', map, log.label),
  );
  new ResizeObserver(() =>
    cover(viewport, place, strip.matches && !isEmbedded ? 'bottom' : null),
  ).observe(place);
  const toleranceRow = tolerance.closest('div') as HTMLElement;

  /** Returns the unit for all values: that of the tolerance, or else of the greatest value. */
  function unitNow() {
    const state = store.get();
    const about = declared(state, state.measure);
    const size = (about && toleranceOf(state, about)) ?? state.spread?.axis.high ?? 0;
    return about ? unitOf(about, size, state.document?.units ?? '') : { unit: '', factor: 1 };
  }

  /** Makes a field for a value in the unit of the legend; null if empty. */
  function field(name: string, accept: (value: number | null) => void) {
    const input = element('input', {
      type: 'text',
      inputMode: 'decimal',
      'aria-label': name,
      oninput: () => input.setCustomValidity(''),
      onchange: () => {
        const value = numberIn(input);
        if (value === undefined || (value === 0 && input === tolerance)) {
          const least = input === tolerance ? 'above' : 'from';
          input.setCustomValidity(`“${input.value}” is no number ${least} 0.`);
          return input.reportValidity();
        }
        accept(value === null ? null : value / unitNow().factor);
      },
      onblur: () => {
        input.setCustomValidity('');
        show();
      },
    });
    return input;
  }

  function show() {
    const state = store.get();
    const { measure, range, spread, document, model, flatMap, display } = state;
    const about = declared(state, measure);
    // A flat map has its own colours and legend.
    const isShown = about && !flatMap && model?.faces;
    place.hidden = !isShown || !isDrawn(state);
    if (!about || !model || place.hidden) return;
    setText(title, about.label);
    setAttribute(title, 'title', about.words);
    log.box.checked = display.log;
    if (!spread) return;
    const allowed = toleranceOf(state, about);
    // Signed values have their own map, no tolerance, and a symmetric range.
    map.hidden = log.label.hidden = toleranceRow.hidden = about.signed;
    low.disabled = about.signed;
    // Without a tolerance, the maps relative to it do not apply.
    setOptions(
      map,
      MAPS.filter(([name]) => allowed !== null || (name !== BEYOND && name !== 'diverging')),
    );
    const isFull = allowed === null || display.full;
    map.value = !isFull
      ? BEYOND
      : map.querySelector(`[value=${display.map}]`)
        ? display.map
        : 'viridis';
    const units = document?.units ?? '';
    const { unit: sign, factor } = unitNow();
    const step = display.log ? null : viewport.unmeasured((view) => view.bandStep());
    const steps = step && `steps of ${Number((step * factor).toPrecision(3))} `;
    setText(unit, `${steps ?? ''}${sign}`);
    setText(toleranceUnit, sign);
    for (const [input, text] of [
      [low, number(range[0] * factor)],
      [high, number(range[1] * factor)],
      [tolerance, allowed === null ? '' : round(allowed * factor)],
    ] as const) {
      if (input === globalThis.document.activeElement) continue;
      if (input.value !== text) input.value = text;
    }

    const { axis, places } = spread;
    const limit = 100 * (places.tolerance ?? 0);
    const neutral = display.full ? 0 : limit;
    ramp.style.background = rampOf(viewport, [100 * places.low, 100 * places.high], neutral);
    const rounding = model.roundings[about.id];
    const words = (value: number) =>
      valueInWords(about, Math.abs(value) < rounding ? 0 : value, units, allowed);
    ends.forEach((end, i) => end.show(spread, words(range[i]), i === 0 && about.signed));
    drawBars(now, spread.counts);
    tick.hidden = allowed === null || allowed > axis.high;
    tick.style.left = `${limit}%`;

    const worst = words(spread.greatest);
    const was = spread.original && words(spread.original.greatest);
    const compared = was === null ? '' : `; originally up to ${was}`;
    const named = `${groupDigits(spread.faces)} faces between ${about.signed ? words(-spread.greatest) : 0} and ${worst}${compared}`;
    setAttribute(histogram, 'aria-label', named);
    // Each histogram is scaled to its own highest bar, to compare their shapes.
    drawOutline(
      before,
      spread.original?.counts ?? null,
      Math.max(...(spread.original?.counts ?? [])),
    );
    setAttribute(histogram, 'title', was === null ? '' : `Outline: the original, up to ${was}`);
    const [met, all] = [spread.within, spread.faces].map(groupDigits);
    setText(within, allowed === null ? '' : `${met} of ${all}`);
    setAttribute(within, 'class', allowed !== null && met === all ? 'within met' : 'within');
    const moved = movedInWords(state);
    setText(facts, `${about.signed ? 'Greatest' : 'Worst'} ${worst}${moved && `\nMoved ${moved}`}`);
  }
  store.subscribe(
    [
      'measure',
      'measures',
      'range',
      'spread',
      'tolerances',
      'document',
      'renderer',
      'model',
      'dark',
      'flatMap',
      'display',
    ],
    show,
  );
}

/** A decimal number, which `Number` reads, and nothing else that it reads. */
const DECIMAL = /^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i;

/** Returns the number in a field; null if it is empty, undefined if it has none from zero. */
function numberIn(input: HTMLInputElement) {
  const text = input.value.trim();
  if (text === '') return null;
  const value = DECIMAL.test(text) ? Number(text.replace(',', '.')) : NaN;
  return value >= 0 && Number.isFinite(value) ? value : undefined;
}
