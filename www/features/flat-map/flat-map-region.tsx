/**
 * The region of the canvas with the flat map: its caption, its legend with the histogram of the
 * errors, and the gestures that pan and zoom it.
 */

import './flat-map.css';
import { useEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { count, ratio } from '../../ui/format.ts';
import { bindMoveKeys, pair, wheelFactor } from '../../viewport/input/gestures.ts';
import type { FlatMap } from '../../store/state.ts';
import type { Viewport } from '../../viewport/viewport.ts';

/** Pan of an arrow key in CSS pixels. */
const KEY_STEP = 32;

export function FlatMapRegion() {
  const { flatMap, renderer } = useApp().store.state;
  return flatMap && renderer !== 'none' ? <Region flatMap={flatMap} /> : null;
}

function Region({ flatMap }: { flatMap: FlatMap }) {
  const { viewport } = useApp();
  const box = useMapRegion();
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (place.current) new Gestures(place.current, viewport).bind();
  }, [viewport]);
  const { flipped } = flatMap.found;
  const isColoured = [flatMap.onModel, flatMap.onMap].includes('errors');
  const [left, top, width, height] = Array.from(box ?? [], (pixels) => `${pixels}px`);
  return (
    <div
      id="flat-map"
      ref={place}
      role="application"
      aria-label="Flat map"
      tabindex={0}
      hidden={!box}
      data-side={box && box[0] > 0 ? 'right' : 'below'}
      style={{ left, top, width, height }}
    >
      <span class="caption">
        Flat map
        {flipped > 0 && <span class="flipped">{`${count(flipped, 'triangle')} flipped`}</span>}
      </span>
      {isColoured && box && <Legend flatMap={flatMap} />}
    </div>
  );
}

/** The map's region of the canvas: left, top, width and height. */
function useMapRegion() {
  const { store, viewport } = useApp();
  const { renderer } = store.state;
  const [box, setBox] = useState<Float32Array | null>(null);
  // After the view has been told of the map.
  useEffect(() => {
    const arrange = () => setBox(viewport.with((view) => view.mapRegion()) ?? null);
    const observer = new ResizeObserver(arrange);
    observer.observe(viewport.element);
    return () => observer.disconnect();
  }, [viewport, renderer]);
  return box;
}

/** The histogram of the faces by error, each bar in the colour of its error. */
function Legend({ flatMap: { found } }: { flatMap: FlatMap }) {
  const { viewport } = useApp();
  const { histogram, high, max } = found;
  const counts = [...histogram];
  const stops = viewport.unmeasured((view) => view.colourStops(counts.length)) ?? [];
  const most = Math.max(...counts, 1);
  const total = counts.reduce((sum, count) => sum + count, 0);
  return (
    <div class="card map-legend">
      <span
        class="title"
        title="The greater stretch of each face divided by the smaller: 1 where angles are kept"
      >
        Quasi-conformal error
      </span>
      <div
        class="bars"
        role="img"
        aria-label={`Histogram of the error of ${total} faces, from 1 to ${ratio(high)}`}
      >
        {counts.map((count, k) => {
          // Keeps a bar of a few faces among thousands visible.
          const height = count > 0 ? Math.max((100 * count) / most, 4) : 0;
          return <i key={k} style={{ height: `${height}%`, background: stops[k] }} />;
        })}
      </div>
      <div class="ramp" style={{ background: `linear-gradient(to right,${stops.join()})` }} />
      <div class="ends figure">
        <span>1</span>
        <span>{`${max > high ? '≥ ' : ''}${ratio(high)}`}</span>
      </div>
    </div>
  );
}

/** What pans and zooms the map. */
class Gestures {
  #place;
  #viewport;
  /** Last position of each pressed pointer. */
  #down: Map<number, [number, number]> = new Map();

  /** @param place over the canvas */
  constructor(place: HTMLElement, viewport: Viewport) {
    this.#place = place;
    this.#viewport = viewport;
  }

  /** Listens for as long as the place is there. */
  bind() {
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
