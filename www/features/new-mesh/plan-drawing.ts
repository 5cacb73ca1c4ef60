/** The drawing of a plan: points to drag, arcs to pull out of sides, and loops to draw. */

import { element } from '../../ui/dom.ts';
import { ARROWS } from '../../ui/keys.ts';
import { svgElement } from '../../ui/svg.ts';
import { bulgeThrough, drawnPlan, planGridStep } from '../../pkg/engine/shape_up.js';
import type { DrawnSide, PlanDrawing, PlanPoint } from '../../pkg/engine/shape_up.js';

export type Place = [number, number];

/** Loop (0: outline) and point in it. */
export type Spot = { loop: number; point: number };

/** Approximate number of grid steps across the drawing. */
const STEPS = 24;
/** Margin around the plan, as a fraction of the drawing. */
const MARGIN = 0.14;
/** Snapping distance in pixels. */
const NEAR = 8;

const loopName = ({ loop }: Spot) => (loop ? `hole ${loop}` : 'the outline');

/**
 * @param on callbacks
 * @param on.begin called before a change
 */
export function planDrawing(on: {
  select: (spot: Spot) => void;
  begin: () => void;
  change: (spot: Spot, point: Partial<PlanPoint>) => void;
  remove: (spot: Spot) => void;
  drawn: (places: Place[]) => void;
  hint: (hint: string) => void;
}) {
  const picture = svgElement('svg', { role: 'group', 'aria-label': 'Plan' });
  const place = element('div.plan-drawing', picture);
  let loops: PlanPoint[][] = [];
  let sides: PlanDrawing = drawnPlan(loops);
  let selected: Spot = { loop: 0, point: 0 };
  let unit = '';
  /** Sides that cross, given by their start points. */
  let crossing: Spot[] = [];
  /** The visible part of the plan: its centre, and pixels per unit. */
  let view = { middle: [0, 0] as Place, scale: 1 };
  let step = 1;
  /** The current drag. */
  let drag: { spot: Spot; arc: boolean; moved: boolean } | null = null;
  /** The points of a loop that is being drawn. */
  let drawing: Place[] | null = null;
  /** The pointer's position during drawing. */
  let pointer: Place | null = null;

  const toPixels = ([x, y]: Place): Place => [
    picture.clientWidth / 2 + view.scale * (x - view.middle[0]),
    picture.clientHeight / 2 - view.scale * (y - view.middle[1]),
  ];
  function under(event: PointerEvent): Place {
    const { left, top } = picture.getBoundingClientRect();
    return [
      view.middle[0] + (event.clientX - left - picture.clientWidth / 2) / view.scale,
      view.middle[1] - (event.clientY - top - picture.clientHeight / 2) / view.scale,
    ];
  }

  /**
   * Snaps each coordinate to a nearby point's or the grid, unless `free` (Alt held).
   * @param own the point that is moved
   */
  function snapped(at: Place, free: boolean, own?: Spot): Place {
    if (free) return at;
    const others = loops.flatMap((points, loop) =>
      points.filter((_, point) => loop !== own?.loop || point !== own.point).map((one) => one.at),
    );
    const all = [...others, ...(drawing ?? [])];
    const near = (axis: 0 | 1) => {
      const other = all.find((one) => Math.abs(one[axis] - at[axis]) * view.scale < NEAR);
      return other ? other[axis] : Number((Math.round(at[axis] / step) * step).toPrecision(12));
    };
    return [near(0), near(1)];
  }

  function fit() {
    const { low, high } = sides;
    const size = [high[0] - low[0], high[1] - low[1]];
    const room = 1 - 2 * MARGIN;
    const scale = Math.min(
      (room * picture.clientWidth) / (size[0] || 1),
      (room * picture.clientHeight) / (size[1] || 1),
    );
    view = { middle: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2], scale };
    step = planGridStep(picture.clientWidth / scale, STEPS);
  }

  function grid() {
    const [width, height] = [picture.clientWidth, picture.clientHeight];
    const lines = [];
    const first = (low: number) => Math.ceil(low / step) * step;
    const [left, bottom] = [
      view.middle[0] - width / 2 / view.scale,
      view.middle[1] - height / 2 / view.scale,
    ];
    for (let x = first(left); x < left + width / view.scale; x += step)
      lines.push(`M${toPixels([x, 0])[0]} 0V${height}`);
    for (let y = first(bottom); y < bottom + height / view.scale; y += step)
      lines.push(`M0 ${toPixels([0, y])[1]}H${width}`);
    return svgElement('path', { class: 'grid', d: lines.join('') });
  }

  const pointPath = (at: Place) => toPixels(at).join(' ');

  /** A side as path data, from the current point of the path. */
  function lineTo(points: PlanPoint[], { radius, clockwise }: DrawnSide, k: number) {
    const end = pointPath(points[(k + 1) % points.length].at);
    if (radius === null) return `L${end}`;
    const pixels = view.scale * radius;
    return `A${pixels} ${pixels} 0 0 ${clockwise ? 1 : 0} ${end}`;
  }

  const sidePath = (points: PlanPoint[], drawn: DrawnSide[], k: number) =>
    `M${pointPath(points[k].at)}${lineTo(points, drawn[k], k)}`;

  const loopPath = (points: PlanPoint[], drawn: DrawnSide[]) =>
    `M${pointPath(points[0].at)}${drawn.map((side, k) => lineTo(points, side, k)).join('')}Z`;

  const keyOf = ({ loop, point }: Spot, arc: boolean) =>
    `${arc ? 'arc' : 'point'} ${loop} ${point}`;

  function pointHandle({ at, corner }: PlanPoint, spot: Spot) {
    const isSelected = spot.loop === selected.loop && spot.point === selected.point;
    const where = at.map((x) => Number(x.toPrecision(6))).join(', ');
    const handle = svgElement('g', {
      class: `point${corner ? ' corner' : ''}`,
      role: 'button',
      tabindex: isSelected ? 0 : -1,
      'aria-pressed': String(isSelected),
      'aria-label': `Point ${spot.point + 1} of ${loopName(spot)}, ${where} ${unit}${corner ? ', corner' : ''}`,
      'data-key': keyOf(spot, false),
      transform: `translate(${toPixels(at).join(' ')})`,
    });
    handle.append(svgElement('circle', { class: 'reach', r: 14 }));
    handle.append(
      corner
        ? svgElement('rect', { class: 'dot', x: -5, y: -5, width: 10, height: 10 })
        : svgElement('circle', { class: 'dot', r: 5 }),
    );
    return handle;
  }

  function arcHandle({ middle }: DrawnSide, spot: Spot) {
    const handle = svgElement('g', {
      class: 'arc',
      'data-key': keyOf(spot, true),
      transform: `translate(${toPixels(middle).join(' ')})`,
    });
    handle.append(
      svgElement('circle', { class: 'reach', r: 12 }),
      svgElement('circle', { class: 'dot', r: 3 }),
    );
    return handle;
  }

  function sketch() {
    if (!drawing) return [];
    const all = [...drawing, ...(pointer ? [pointer] : [])].map((at) => toPixels(at).join(' '));
    const dots = drawing.map((at) => {
      const [cx, cy] = toPixels(at);
      return svgElement('circle', { class: 'drawn', cx, cy, r: 5 });
    });
    return all.length
      ? [svgElement('path', { class: 'drawn', d: `M${all.join('L')}` }), ...dots]
      : [];
  }

  function draw() {
    const focused = document.activeElement?.closest('[data-key]')?.getAttribute('data-key');
    const shape = loops.map((points, loop) => loopPath(points, sides.loops[loop])).join('');
    const handles = loops.flatMap((points, loop) => [
      ...sides.loops[loop].map((side, point) => arcHandle(side, { loop, point })),
      ...points.map((one, point) => pointHandle(one, { loop, point })),
    ]);
    picture.classList.toggle('drawing', Boolean(drawing));
    picture.replaceChildren(
      grid(),
      svgElement('path', { class: 'shape', d: shape, 'fill-rule': 'evenodd' }),
      ...crossing
        .filter(({ loop, point }) => loops[loop]?.[point])
        .map(({ loop, point }) =>
          svgElement('path', {
            class: 'crossing',
            d: sidePath(loops[loop], sides.loops[loop], point),
          }),
        ),
      ...(drawing ? [] : handles),
      ...sketch(),
    );
    const again = focused && picture.querySelector(`[data-key="${focused}"]`);
    if (again instanceof SVGElement) again.focus({ preventScroll: true });
  }

  function handleUnder(event: Event) {
    const target = event.target instanceof Element ? event.target.closest('[data-key]') : null;
    const [kind, loop, point] = target?.getAttribute('data-key')?.split(' ') ?? [];
    if (!kind) return null;
    return { arc: kind === 'arc', spot: { loop: Number(loop), point: Number(point) } };
  }

  function focusOn(spot: Spot) {
    const handle = picture.querySelector(`[data-key="${keyOf(spot, false)}"]`);
    if (handle instanceof SVGElement) handle.focus({ preventScroll: true });
  }

  picture.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    if (drawing) return addPlace(snapped(under(event), event.altKey));
    const found = handleUnder(event);
    if (!found) return;
    drag = { ...found, moved: false };
    picture.setPointerCapture(event.pointerId);
    on.select(found.spot);
    focusOn(found.spot);
  });
  picture.addEventListener('pointermove', (event) => {
    if (drawing) {
      pointer = snapped(under(event), event.altKey);
      const last = drawing.at(-1);
      if (last) {
        const length = Math.hypot(pointer[0] - last[0], pointer[1] - last[1]);
        on.hint(`${Number(length.toPrecision(4))} ${unit}`);
      }
      return draw();
    }
    if (!drag) return;
    if (!drag.moved) on.begin();
    drag.moved = true;
    const { spot, arc } = drag;
    if (!arc) return on.change(spot, { at: snapped(under(event), event.altKey, spot) });
    const through = Float64Array.from(under(event));
    const bulge = bulgeThrough(loops, spot.loop, spot.point, through);
    const { chord } = sides.loops[spot.loop][spot.point];
    const isFlat = Math.abs(bulge) * chord * view.scale < 2 * NEAR && !event.altKey;
    on.change(spot, { bulge: isFlat ? 0 : bulge });
  });
  const release = () => {
    const wasMoved = drag?.moved;
    drag = null;
    if (wasMoved) show();
  };
  picture.addEventListener('pointerup', release);
  picture.addEventListener('pointercancel', release);

  picture.addEventListener('focusin', (event) => {
    const found = handleUnder(event);
    const { loop, point } = selected;
    if (found && (found.spot.loop !== loop || found.spot.point !== point)) on.select(found.spot);
  });
  place.addEventListener('keydown', (event) => {
    if (drawing) return drawByKey(event);
    if (!handleUnder(event)) return;
    const { at } = loops[selected.loop][selected.point];
    const by = ARROWS[event.key];
    if (by) {
      on.begin();
      const one = event.shiftKey ? step / 10 : step;
      on.change(selected, { at: [at[0] + one * by[0], at[1] - one * by[1]] });
    } else if (event.key === 'Delete' || event.key === 'Backspace') on.remove(selected);
    else return;
    event.preventDefault();
  });

  function addPlace(at: Place) {
    if (!drawing) return;
    const [first] = drawing;
    const isSame = (other: Place | undefined) =>
      other && Math.hypot(at[0] - other[0], at[1] - other[1]) * view.scale < NEAR;
    if (isSame(first)) return close();
    if (!isSame(drawing.at(-1))) drawing.push(at);
    draw();
  }

  function close() {
    if (!drawing || drawing.length < 3) return;
    const places = drawing;
    drawing = null;
    on.drawn(places);
  }

  function drawByKey(event: KeyboardEvent) {
    if (event.key === 'Enter') close();
    else if (event.key === 'Backspace') drawing?.pop();
    else return;
    event.preventDefault();
    draw();
  }

  function show() {
    if (!drag && !drawing) fit();
    draw();
  }
  new ResizeObserver(show).observe(picture);

  return {
    element: place,
    /**
     * @param drawn the same loops as they are drawn
     * @param spot the point that is selected
     * @param symbol of the unit
     */
    show(shown: PlanPoint[][], drawn: PlanDrawing, spot: Spot, symbol: string) {
      [loops, sides, selected, unit] = [shown, drawn, spot, symbol];
      show();
    },
    focus: () => focusOn(selected),
    /** Marks sides that cross. */
    mark(sides: Spot[]) {
      if (sides.length === 0 && crossing.length === 0) return;
      crossing = sides;
      draw();
    },
    /** Begins to draw a loop. */
    draw() {
      drawing = [];
      pointer = null;
      picture.setAttribute('tabindex', '-1');
      picture.focus({ preventScroll: true });
      draw();
    },
    isDrawing: () => Boolean(drawing),
    /** Ends drawing and discards the unfinished loop. */
    stop() {
      drawing = null;
    },
    /** Removes the last drawn point; ends drawing if there is none. */
    back() {
      if (!drawing?.pop()) drawing = null;
      draw();
    },
  };
}
