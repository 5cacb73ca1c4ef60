/**
 * The region of the canvas with the flat map: its caption, its legend with the histogram of the
 * errors, and the gestures that pan and zoom it.
 */

import './flat-map.css';
import { useEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { count, ratio } from '../../ui/words.ts';
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
    if (place.current) bindGestures(place.current, viewport);
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
        title="The larger stretch of each face divided by the smaller: 1 where angles are kept (quasi-conformal error)"
      >
        Angle distortion (1 = none)
      </span>
      <div
        class="bars"
        role="img"
        aria-label={`Histogram of the angle distortion of ${count(total, 'face')}, from 1 to ${ratio(high)}`}
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

/**
 * Pans and zooms the map for as long as its place is there. One pointer pans it; two pan it by their
 * midpoint and zoom it by their distance.
 */
function bindGestures(place: HTMLElement, viewport: Viewport) {
  /** Last position of each pressed pointer. */
  const down: Map<number, [number, number]> = new Map();
  const listen: HTMLElement['addEventListener'] = place.addEventListener.bind(place);

  function at(event: MouseEvent): [number, number] {
    const { left, top } = place.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  listen('pointerdown', (event) => {
    place.focus({ preventScroll: true });
    place.setPointerCapture(event.pointerId);
    down.set(event.pointerId, at(event));
    // The middle button would scroll.
    event.preventDefault();
  });
  listen('pointermove', (event) => {
    const last = down.get(event.pointerId);
    if (!last) return;
    const now = at(event);
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    down.set(event.pointerId, now);
    const share = other ? 0.5 : 1;
    viewport.with((view) => {
      view.panMap(share * (now[0] - last[0]), share * (now[1] - last[1]));
      if (!other) return;
      const [from, to] = [pair(last, other), pair(now, other)];
      if (from.apart > 0 && to.apart > 0) view.zoomMap(to.apart / from.apart, to.x, to.y);
    });
  });
  for (const type of ['pointerup', 'pointercancel'] as const)
    listen(type, (event) => down.delete(event.pointerId));
  listen('dblclick', () => viewport.with((view) => view.fitMap()));
  listen('contextmenu', (event) => event.preventDefault());
  const onWheel = (event: WheelEvent) => {
    event.preventDefault();
    const factor = wheelFactor(event, place.clientHeight);
    viewport.with((view) => view.zoomMap(factor, ...at(event)));
  };
  listen('wheel', onWheel, { passive: false });
  bindMoveKeys(place, {
    move: (x, y) => viewport.with((view) => view.panMap(-KEY_STEP * x, -KEY_STEP * y)),
    zoom: (...about) => viewport.with((view) => view.zoomMap(...about)),
  });
}
