/**
 * The legend of the face colours: a histogram of their values over the colour ramp, the ends of the
 * range, the number of faces within the tolerance, and the displacement of the mesh.
 */

import { cover } from '../../viewport/camera.ts';
import { rampOf } from '../../viewport/ramp.ts';
import { element, setAttribute, setText } from '../../ui/dom.ts';
import { isEmbedded } from '../../ui/embedded.ts';
import { groupDigits, number } from '../../ui/format.ts';
import {
  declared,
  movedInWords,
  shownUnit,
  toleranceOf,
  valueInWords,
} from '../../store/colours/measures.ts';
import { bars, drawBars, drawOutline, outline } from '../../ui/plot/histogram-svg.ts';
import { isDrawn } from '../../store/state.ts';
import { rangeEnd } from './range-end.ts';
import type { AppContext } from '../../app/context.ts';

/** On a phone in landscape orientation the legend is a strip below the model. */
const strip = matchMedia('(min-width: 700px) and (max-height: 480px)');

export function legend(place: HTMLElement, app: AppContext) {
  const { store, viewport } = app;
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
  const [low, high] = [element('span'), element('span')];
  const within = element('span.within', { title: 'Faces within the tolerance' });
  const facts = element('p.quiet.summary');
  place.replaceChildren(
    element('div.title', title, within),
    histogram,
    ramp,
    element('div.ends', low, unit, high),
    facts,
  );
  new ResizeObserver(() =>
    cover(viewport, place, strip.matches && !isEmbedded ? 'bottom' : null),
  ).observe(place);
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
    if (!spread) return;
    const allowed = toleranceOf(state, about);
    const units = document?.units ?? '';
    const { unit: sign, factor } = shownUnit(state);
    const step = display.log ? null : viewport.unmeasured((view) => view.bandStep());
    const steps = step && `steps of ${Number((step * factor).toPrecision(3))} `;
    setText(unit, `${steps ?? ''}${sign}`);
    setText(low, number(range[0] * factor));
    setText(high, number(range[1] * factor));

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
