/** Where the camera looks: its motions, elements that cover the view, and elements to reveal. */

import { between, isMoved } from './flight.ts';
import { cornersOf, verticesOf } from '../store/selection.ts';
import type { Viewport } from './viewport.ts';
import type { View } from './layers.ts';
import type { AppContext } from '../app/context.ts';
import type { Connectivity } from '../solver/types.ts';

const FLIGHT_MS = 320;
const still = matchMedia('(prefers-reduced-motion: reduce)');
/** Seconds in which a model that turns slowly turns once. */
const TURN_SECONDS = 24;

/** Moves the camera as `change` does: animated, or at once if the user prefers reduced motion. */
export function fly(viewport: Viewport, change: (view: View) => void) {
  viewport.with((view) => {
    viewport.arrive();
    viewport.motion = null;
    if (still.matches) return change(view);
    const from = view.camera();
    change(view);
    const to = view.camera();
    const started = performance.now();
    view.placeCamera(between(from, to, 0));
    animate(viewport, view, to, (view, now) => {
      const part = (now - started) / FLIGHT_MS;
      if (part >= 1) viewport.arrive();
      else view.placeCamera(between(from, to, part));
    });
  });
}

/**
 * Turns the model slowly, as on a turntable, until the camera is moved otherwise or another mesh is
 * shown; or stops that.
 */
export function turnSlowly(viewport: Viewport) {
  if (viewport.motion && !viewport.motion.to) return stopTurning(viewport);
  viewport.with((view) => {
    viewport.arrive();
    let last = performance.now();
    animate(viewport, view, null, (view, now) => {
      // A page that was hidden continues from the same angle.
      const passed = Math.min(now - last, 100);
      last = now;
      view.spin((2 * Math.PI * passed) / 1000 / TURN_SECONDS);
    });
  });
}

/** Ends the turning of the model, if it turns. */
export function stopTurning(viewport: Viewport) {
  if (!viewport.motion?.to) viewport.motion = null;
}

/** Takes a step in each frame, until another motion begins or the camera is moved otherwise. */
function animate(
  viewport: Viewport,
  view: View,
  to: Float64Array | null,
  step: (view: View, now: number) => void,
) {
  const motion = { to };
  viewport.motion = motion;
  let at = view.camera();
  const on = () =>
    viewport.unmeasured((view) => {
      if (viewport.motion !== motion) return;
      if (isMoved(view.camera(), at)) return void (viewport.motion = null);
      step(view, performance.now());
      at = view.camera();
      requestAnimationFrame(on);
    });
  requestAnimationFrame(on);
}

/** Windows in which messages and cards lie below the model. */
export const narrow = matchMedia('(max-width: 699px)');

/** Gap between the model and the elements that cover the view, in CSS pixels. */
const GAP = 14;

/** Heights of the view covered by each element from the upper and lower edge, in CSS pixels. */
const heights: Map<HTMLElement, { top: number; bottom: number }> = new Map();

/**
 * Records how much of the view an element covers.
 * @param edge the edge that it lies along when visible, if any
 * @returns covered height, in CSS pixels
 */
export function cover(
  viewport: Viewport,
  element: HTMLElement,
  edge: 'top' | 'bottom' | null = 'bottom',
): number {
  const { hidden, offsetTop, offsetHeight, offsetParent } = element;
  const height = offsetParent?.clientHeight ?? 0;
  const isThere = edge !== null && !hidden && height > 0 && offsetHeight > 0;
  const covered = isThere
    ? GAP + (edge === 'top' ? offsetTop + offsetHeight : height - offsetTop)
    : 0;
  heights.set(element, { top: 0, bottom: 0, [edge ?? 'bottom']: covered });
  frame(viewport);
  return covered;
}

/** Forgets an element that is removed. */
export function uncover(viewport: Viewport, element: HTMLElement) {
  if (heights.delete(element)) frame(viewport);
}

/** Frames the model in the part that is not covered. */
function frame(viewport: Viewport) {
  const [top, bottom] = (['top', 'bottom'] as const).map((edge) =>
    Math.max(0, ...[...heights.values()].map((by) => by[edge])),
  );
  viewport.with((view) => view.cover(top, bottom));
}

type Elements = {
  vertices: ArrayLike<number>;
  edges?: ArrayLike<number>;
  faces: ArrayLike<number>;
};

/** Rings of faces around the elements to include in the picture, for orientation. */
const RINGS = 2;

/**
 * Selects elements and moves the camera to them.
 * @param elements their vertices, edges and faces
 */
export function showElements(
  { actions, solver, viewport }: AppContext,
  { vertices, edges = [], faces }: Elements,
) {
  const { geometry } = solver;
  if (!geometry) return;
  const { connectivity } = geometry;
  const all = actions.select({
    vertices: Array.from(vertices),
    edges: Array.from(edges),
    faces: Array.from(faces),
  });
  let around = new Set(verticesOf(all, connectivity));
  for (let ring = 0; ring < RINGS; ring++) around = withNeighbours(connectivity, around);
  if (around.size > 0) viewport.with((view) => view.fitVertices(Uint32Array.from(around)));
}

/** Returns the vertices together with those of all faces incident to them. */
function withNeighbours(connectivity: Connectivity, vertices: Set<number>) {
  const all = new Set(vertices);
  for (let face = 0; face + 1 < connectivity.faceOffsets.length; face++) {
    const own = cornersOf(connectivity, face);
    if (own.some((vertex) => vertices.has(vertex))) own.forEach((vertex) => all.add(vertex));
  }
  return all;
}
