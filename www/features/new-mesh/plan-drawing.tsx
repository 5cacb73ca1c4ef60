/** The drawing of a plan: points to drag, arcs to pull out of sides, and loops to draw. */

import { useLayoutEffect, useRef } from 'preact/hooks';
import { useSize } from '../../ui/components/use-size.ts';
import { ARROWS } from '../../ui/keys.ts';
import { brief, rounded } from '../../ui/words.ts';
import { bulgeThrough, planGridStep } from '../../pkg/engine/shape_up.js';
import { nameOf, type DrawnPlan, type Place, type Sketch, type Spot } from './plan.ts';
import type { DrawnSide, PlanDrawing as Drawing, PlanPoint } from '../../pkg/engine/shape_up.js';

/** Approximate number of grid steps across the drawing. */
const STEPS = 24;
/** Margin around the plan, as a fraction of the drawing. */
const MARGIN = 0.14;
/** Snapping distance in pixels. */
const NEAR = 8;

/** The visible part of the plan: the size of the drawing, its middle, pixels per unit, grid step. */
interface View {
  size: Place;
  middle: Place;
  scale: number;
  step: number;
}

function viewOf({ low, high }: Drawing, size: Place): View {
  const across = size.map(
    (side, axis) => ((1 - 2 * MARGIN) * side) / (high[axis] - low[axis] || 1),
  );
  const scale = Math.min(...across);
  const middle: Place = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  return { size, middle, scale, step: scale > 0 ? planGridStep(size[0] / scale, STEPS) : 1 };
}

const toPixels = ({ size, middle, scale }: View, [x, y]: Place): Place => [
  size[0] / 2 + scale * (x - middle[0]),
  size[1] / 2 - scale * (y - middle[1]),
];
const toPlan = ({ size, middle, scale }: View, [x, y]: Place): Place => [
  middle[0] + (x - size[0] / 2) / scale,
  middle[1] - (y - size[1] / 2) / scale,
];
const apart = (p: Place, q: Place) => Math.hypot(p[0] - q[0], p[1] - q[1]);

export function PlanDrawing({ drawn }: { drawn: DrawnPlan }) {
  const picture = useRef<SVGSVGElement>(null);
  const size = useSize(picture);
  const { drag } = drawn;
  const loops = drawn.loops.value;
  const sides = drawn.sides.value;
  const sketch = drawn.sketch.value;
  // What is moved or drawn stays under the pointer.
  const last = useRef<View | null>(null);
  const isHeld = sketch !== null || drag.value !== null;
  const view = isHeld && last.current ? last.current : viewOf(sides, size);
  last.current = view;

  useFocus(picture, drawn, sketch !== null);

  function under({ clientX, clientY }: PointerEvent): Place {
    const { left = 0, top = 0 } = picture.current?.getBoundingClientRect() ?? {};
    return toPlan(view, [clientX - left, clientY - top]);
  }

  /**
   * The place under the pointer; unless Alt is held, each coordinate snaps to that of a point nearby
   * or to the grid.
   * @param own the point that is moved
   */
  function snapped(event: PointerEvent, own?: Spot): Place {
    const at = under(event);
    if (event.altKey) return at;
    const others = loops.flatMap((points, loop) =>
      points.filter((_, point) => loop !== own?.loop || point !== own.point).map((one) => one.at),
    );
    const all = [...others, ...(sketch?.places ?? [])];
    const near = (axis: 0 | 1) => {
      const other = all.find((one) => Math.abs(one[axis] - at[axis]) * view.scale < NEAR);
      const { step } = view;
      return other ? other[axis] : rounded(Math.round(at[axis] / step) * step, 12);
    };
    return [near(0), near(1)];
  }

  function place({ places, of }: Sketch, at: Place) {
    const isAt = (other: Place | undefined) => other && apart(at, other) * view.scale < NEAR;
    if (isAt(places[0])) return drawn.closeSketch();
    if (!isAt(places.at(-1))) drawn.sketch.value = { of, places: [...places, at], pointer: at };
  }

  function grab(event: PointerEvent, spot: Spot, arc: boolean) {
    if (event.button !== 0) return;
    // What is typed in a field is about the point that is selected until now.
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    drag.value = { spot, arc, moved: false, pointer: event.pointerId };
    picture.current?.setPointerCapture(event.pointerId);
    drawn.select(spot);
    drawn.wantsFocus = true;
  }

  function move(event: PointerEvent) {
    if (sketch) drawn.sketch.value = { ...sketch, pointer: snapped(event) };
    // Another finger has no part in it.
    if (drag.value?.pointer !== event.pointerId) return;
    const { spot, arc, moved } = drag.value;
    if (!moved) {
      drawn.remember();
      drag.value = { ...drag.value, moved: true };
    }
    if (!arc) return drawn.edit((_, __, point) => (point.at = snapped(event, spot)));
    const through = Float64Array.from(under(event));
    const bulge = bulgeThrough(loops, spot.loop, spot.point, through);
    const { chord } = sides.loops[spot.loop][spot.point];
    const isFlat = Math.abs(bulge) * chord * view.scale < 2 * NEAR && !event.altKey;
    drawn.edit((_, __, point) => (point.bulge = isFlat ? 0 : bulge));
  }

  function drawByKey(event: KeyboardEvent) {
    if (!sketch) return;
    if (event.key === 'Enter') drawn.closeSketch();
    else if (event.key === 'Backspace') {
      drawn.sketch.value = { ...sketch, places: sketch.places.slice(0, -1) };
    } else return;
    event.preventDefault();
  }

  const release = ({ pointerId }: PointerEvent) => {
    if (drag.value?.pointer === pointerId) drag.value = null;
  };
  const marked = drawn.crossing.value.filter(({ loop, point }) => loops[loop]?.[point]);
  return (
    <div class="plan-drawing">
      <svg
        ref={picture}
        class={sketch ? 'drawing' : ''}
        role="group"
        aria-label="Plan"
        tabindex={-1}
        onPointerDown={(event) => {
          if (event.button !== 0) return;
          event.preventDefault();
          if (sketch) place(sketch, snapped(event));
        }}
        onPointerMove={move}
        onPointerUp={release}
        onPointerCancel={release}
        onKeyDown={drawByKey}
      >
        <path class="grid" d={gridOf(view)} />
        <path
          class="shape"
          d={loops.map((points, loop) => loopPath(view, points, sides.loops[loop])).join('')}
          fill-rule="evenodd"
        />
        {marked.map(({ loop, point }) => (
          <path
            key={`${loop} ${point}`}
            class="crossing"
            d={sidePath(view, loops[loop], sides.loops[loop], point)}
          />
        ))}
        {sketch
          ? sketched(view, sketch)
          : loops.map((points, loop) => [
              ...sides.loops[loop].map(({ middle }, point) => (
                <g
                  key={`arc ${loop} ${point}`}
                  class="arc"
                  transform={`translate(${toPixels(view, middle).join(' ')})`}
                  onPointerDown={(event) => grab(event, { loop, point }, true)}
                >
                  <circle class="reach" r={12} />
                  <circle class="dot" r={3} />
                </g>
              )),
              ...points.map((point, k) => (
                <Point
                  key={`point ${loop} ${k}`}
                  drawn={drawn}
                  spot={{ loop, point: k }}
                  point={point}
                  at={toPixels(view, point.at)}
                  step={view.step}
                  grab={(event) => grab(event, { loop, point: k }, false)}
                />
              )),
            ])}
      </svg>
    </div>
  );
}

/** A point, which is moved by dragging and by the arrow keys. */
function Point({
  drawn,
  spot,
  point: { at, corner },
  at: [x, y],
  step,
  grab,
}: {
  drawn: DrawnPlan;
  spot: Spot;
  point: PlanPoint;
  /** in pixels */
  at: Place;
  /** of the grid */
  step: number;
  grab: (event: PointerEvent) => void;
}) {
  const handle = useRef<SVGGElement>(null);
  const { loop, point } = drawn.selected.value;
  const isSelected = loop === spot.loop && point === spot.point;
  useFocus(handle, drawn, isSelected);

  function moveByKey(event: KeyboardEvent) {
    const by = ARROWS[event.key];
    const far = event.shiftKey ? step / 10 : step;
    if (by) drawn.step((_, __, one) => (one.at = [at[0] + far * by[0], at[1] - far * by[1]]));
    else if (event.key === 'Delete' || event.key === 'Backspace') drawn.removePoint();
    else return;
    event.preventDefault();
  }

  const where = at.map(brief).join(', ');
  return (
    <g
      ref={handle}
      class={corner ? 'point corner' : 'point'}
      role="button"
      tabindex={0}
      aria-pressed={isSelected}
      aria-label={`${nameOf(spot)}, ${where} ${drawn.unit.value}${corner ? ', corner' : ''}`}
      transform={`translate(${x} ${y})`}
      onFocus={() => drawn.select(spot)}
      onPointerDown={grab}
      onKeyDown={moveByKey}
    >
      <circle class="reach" r={14} />
      {corner ? (
        <rect class="dot" x={-5} y={-5} width={10} height={10} />
      ) : (
        <circle class="dot" r={5} />
      )}
    </g>
  );
}

/** Focuses a part of the drawing after a redraw, if `drawn` asks for the focus and it is the target. */
function useFocus(place: { current: SVGElement | null }, drawn: DrawnPlan, isTarget: boolean) {
  useLayoutEffect(() => {
    if (!isTarget || !drawn.wantsFocus) return;
    drawn.wantsFocus = false;
    place.current?.focus({ preventScroll: true });
  });
}

function gridOf(view: View) {
  const { size, step } = view;
  const [left, top] = toPlan(view, [0, 0]);
  const [right, bottom] = toPlan(view, size);
  const lines = [];
  const first = (low: number) => Math.ceil(low / step) * step;
  for (let x = first(left); x < right; x += step)
    lines.push(`M${toPixels(view, [x, 0])[0]} 0V${size[1]}`);
  for (let y = first(bottom); y < top; y += step)
    lines.push(`M0 ${toPixels(view, [0, y])[1]}H${size[0]}`);
  return lines.join('');
}

/** A side as path data, from the current point of the path. */
function lineTo(view: View, points: PlanPoint[], { radius, clockwise }: DrawnSide, k: number) {
  const end = toPixels(view, points[(k + 1) % points.length].at).join(' ');
  if (radius === null) return `L${end}`;
  const pixels = view.scale * radius;
  return `A${pixels} ${pixels} 0 0 ${clockwise ? 1 : 0} ${end}`;
}

const sidePath = (view: View, points: PlanPoint[], drawn: DrawnSide[], k: number) =>
  `M${toPixels(view, points[k].at).join(' ')}${lineTo(view, points, drawn[k], k)}`;

const loopPath = (view: View, points: PlanPoint[], drawn: DrawnSide[]) =>
  `M${toPixels(view, points[0].at).join(' ')}${drawn.map((side, k) => lineTo(view, points, side, k)).join('')}Z`;

function sketched(view: View, { places, pointer }: Sketch) {
  const pixels = [...places, ...(pointer ? [pointer] : [])].map((at) => toPixels(view, at));
  if (pixels.length === 0) return null;
  return (
    <>
      <path class="drawn" d={`M${pixels.map((at) => at.join(' ')).join('L')}`} />
      {pixels.slice(0, places.length).map(([cx, cy], k) => (
        <circle key={k} class="drawn" cx={cx} cy={cy} r={5} />
      ))}
    </>
  );
}
