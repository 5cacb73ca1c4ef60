/**
 * The region of the canvas with the flat map: its caption, its legend with the histogram of the
 * errors, and the gestures that pan and zoom it.
 */

import { element, setText } from '../../ui/dom.ts';
import { count, ratio } from '../../ui/format.ts';
import { bindMoveKeys, pair, wheelFactor } from '../../viewport/input/gestures.ts';
import type { Store } from '../../store/state.ts';
import type { Viewport } from '../../viewport/viewport.ts';
import type { Parametrization } from '../../solver/types.ts';

/** Pan of an arrow key in CSS pixels. */
const KEY_STEP = 32;

export class FlatMapRegion {
  #place;
  #store;
  #viewport;
  #legend = element('div.card.map-legend');
  #flipped = element('span.flipped');
  /** Last position of each pressed pointer. */
  #down: Map<number, [number, number]> = new Map();

  /** @param place over the canvas */
  constructor(place: HTMLElement, store: Store, viewport: Viewport) {
    this.#place = place;
    this.#store = store;
    this.#viewport = viewport;
    place.replaceChildren(element('span.caption', 'Flat map', this.#flipped), this.#legend);
    store.subscribe(['flatMap', 'renderer', 'dark'], () => this.#show());
    new ResizeObserver(() => this.#arrange()).observe(viewport.element);
    this.#listen();
  }

  #show() {
    const { flatMap } = this.#store.get();
    this.#place.hidden = !flatMap || !this.#viewport.view;
    if (!flatMap) return;
    this.#arrange();
    const { flipped } = flatMap.found;
    this.#flipped.hidden = flipped === 0;
    setText(this.#flipped, `${count(flipped, 'triangle')} flipped`);
    const isColoured = flatMap.onModel === 'errors' || flatMap.onMap === 'errors';
    this.#legend.hidden = !isColoured;
    const stops = this.#viewport.with((view) => view.colourStops(flatMap.found.histogram.length));
    if (isColoured && stops) this.#legend.replaceChildren(...histogram(flatMap.found, stops));
  }

  /** Covers the map's region of the canvas, as given by the view. */
  #arrange() {
    const region = this.#store.get().flatMap && this.#viewport.with((view) => view.mapRegion());
    if (!region) return;
    const [left, top, width, height] = region;
    Object.assign(this.#place.style, {
      left: `${left}px`,
      top: `${top}px`,
      width: `${width}px`,
      height: `${height}px`,
    });
    this.#place.dataset.side = left > 0 ? 'right' : 'below';
  }

  #listen() {
    const listen: HTMLElement['addEventListener'] = this.#place.addEventListener.bind(this.#place);
    listen('pointerdown', (event) => {
      this.#place.focus({ preventScroll: true });
      this.#place.setPointerCapture(event.pointerId);
      this.#down.set(event.pointerId, this.#at(event));
      // The middle button would scroll.
      event.preventDefault();
    });
    listen('pointermove', (event) => this.#move(event));
    for (const type of ['pointerup', 'pointercancel'] as const)
      listen(type, (event) => this.#down.delete(event.pointerId));
    listen('dblclick', () => this.#viewport.with((view) => view.fitMap()));
    listen('contextmenu', (event) => event.preventDefault());
    const onWheel = (event: WheelEvent) => {
      event.preventDefault();
      const factor = wheelFactor(event, this.#place.clientHeight);
      this.#viewport.with((view) => view.zoomMap(factor, ...this.#at(event)));
    };
    listen('wheel', onWheel, { passive: false });
    bindMoveKeys(this.#place, {
      move: (x, y) => this.#viewport.with((view) => view.panMap(-KEY_STEP * x, -KEY_STEP * y)),
      zoom: (...about) => this.#viewport.with((view) => view.zoomMap(...about)),
    });
  }

  /**
   * One pointer pans the map. Two pointers pan it by their midpoint and zoom it by their distance.
   */
  #move(event: PointerEvent) {
    const last = this.#down.get(event.pointerId);
    if (!last) return;
    const at = this.#at(event);
    const other = [...this.#down].find(([id]) => id !== event.pointerId)?.[1];
    this.#down.set(event.pointerId, at);
    const share = other ? 0.5 : 1;
    this.#viewport.with((view) => {
      view.panMap(share * (at[0] - last[0]), share * (at[1] - last[1]));
      if (!other) return;
      const [before, now] = [pair(last, other), pair(at, other)];
      if (before.apart > 0 && now.apart > 0) view.zoomMap(now.apart / before.apart, now.x, now.y);
    });
  }

  #at(event: MouseEvent): [number, number] {
    const box = this.#place.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}

/**
 * The histogram of the faces by error, each bar in the colour of its error.
 * @param stops a colour for each bar
 */
function histogram({ histogram: counts, high, max }: Parametrization, stops: string[]) {
  const most = Math.max(...counts, 1);
  const total = counts.reduce((sum, count) => sum + count, 0);
  const bars = [...counts].map((count, k) => {
    // Keeps a bar of a few faces among thousands visible.
    const height = count > 0 ? Math.max((100 * count) / most, 4) : 0;
    return element('i', { style: `height:${height}%;background:${stops[k]}` });
  });
  const title = element('span.title');
  setText(title, 'Quasi-conformal error');
  title.title = 'The greater stretch of each face divided by the smaller: 1 where angles are kept';
  const label = `Histogram of the error of ${total} faces, from 1 to ${ratio(high)}`;
  return [
    title,
    element('div.bars', { role: 'img', 'aria-label': label }, ...bars),
    element('div.ramp', { style: `background:linear-gradient(to right,${stops.join()})` }),
    element(
      'div.ends.figure',
      element('span', '1'),
      element('span', `${max > high ? '≥ ' : ''}${ratio(high)}`),
    ),
  ];
}
