/** The geometry of a plan's loops: their sides, straight or arcs, and their SVG paths. */

import type { PlanPoint } from '../../pkg/engine/shape_up.js';

export type Place = [number, number];

/** Minimum turning angle of a corner in a drawn loop: 20 degrees. */
const SHARP = (20 * Math.PI) / 180;

/** Whether the points run clockwise. Two points, joined by arcs only, never count as clockwise. */
function isClockwise(places: Place[]) {
  const twice = ([x, y]: Place, k: number) => {
    const [nextX, nextY] = places[(k + 1) % places.length];
    return x * nextY - nextX * y;
  };
  return places.reduce((sum, place, k) => sum + twice(place, k), 0) < 0;
}

/** The side from a point to the next one: its chord, the outward unit normal, its midpoint. */
export function sideOf(points: PlanPoint[], k: number) {
  const { at: from, bulge = 0 } = points[k];
  const { at: to } = points[(k + 1) % points.length];
  const along = [to[0] - from[0], to[1] - from[1]];
  const chord = Math.hypot(along[0], along[1]) || 1;
  const sign = isClockwise(points.map(({ at }) => at)) ? -1 : 1;
  const outward = [(sign * along[1]) / chord, (-sign * along[0]) / chord];
  const rise = (bulge * chord) / 2;
  const middle: Place = [
    (from[0] + to[0]) / 2 + rise * outward[0],
    (from[1] + to[1]) / 2 + rise * outward[1],
  ];
  return { from, to, along, chord, outward, rise, middle };
}

/** The bulge of a side whose arc has its midpoint nearest to a given position. */
export function bulgeThrough(points: PlanPoint[], k: number, through: Place) {
  const { from, to, outward, chord } = sideOf(points, k);
  const away = [through[0] - (from[0] + to[0]) / 2, through[1] - (from[1] + to[1]) / 2];
  return clamped((2 * (away[0] * outward[0] + away[1] * outward[1])) / chord);
}

/** Limits a bulge to a half circle. */
export const clamped = (bulge: number) => Math.min(Math.max(bulge, -1), 1);

/**
 * A loop as SVG path data, mapped to pixels by `toPixels`, whose `y` axis points down.
 * @param scale of `toPixels`
 */
export function pathOf(points: PlanPoint[], toPixels: (place: Place) => Place, scale: number) {
  const drawn = points.map((_, k) => lineTo(points, k, toPixels, scale));
  return `M${toPixels(points[0].at).join(' ')}${drawn.join('')}Z`;
}

/**
 * The side from a point to the next one as SVG path data.
 * @param scale of `toPixels`
 */
export function sidePathOf(
  points: PlanPoint[],
  k: number,
  toPixels: (place: Place) => Place,
  scale: number,
) {
  return `M${toPixels(points[k].at).join(' ')}${lineTo(points, k, toPixels, scale)}`;
}

/**
 * The same, from the current point of the path.
 * @param scale of `toPixels`
 */
function lineTo(points: PlanPoint[], k: number, toPixels: (place: Place) => Place, scale: number) {
  const { bulge = 0 } = points[k];
  const { to, chord } = sideOf(points, k);
  const end = toPixels(to).join(' ');
  if (Math.abs(bulge) < 1e-6) return `L${end}`;
  const radius = (scale * chord * (1 + bulge * bulge)) / (4 * Math.abs(bulge));
  // The downward y axis reverses the orientation.
  const sweep = bulge > 0 === isClockwise(points.map(({ at }) => at)) ? 1 : 0;
  return `A${radius} ${radius} 0 0 ${sweep} ${end}`;
}

/** Bounding box of the loops' points and of the midpoints of their arcs. */
export function extentOf(loops: PlanPoint[][]) {
  const places = loops.flatMap((points) =>
    points.flatMap(({ at }, k) => [at, sideOf(points, k).middle]),
  );
  const along = (axis: 0 | 1) => places.map((place) => place[axis]);
  return {
    low: [Math.min(...along(0)), Math.min(...along(1))] as Place,
    high: [Math.max(...along(0)), Math.max(...along(1))] as Place,
  };
}

/** The step of a grid with about `count` steps over a length: 1, 2 or 5 times a power of ten. */
export function roundStep(length: number, count: number) {
  const power = 10 ** Math.floor(Math.log10(length / count));
  return power * ([1, 2, 5].find((one) => one * power * count >= length) ?? 10);
}

/**
 * A drawn loop, made counterclockwise. With `hasCorners`, its sharp convex turns become corners.
 */
export function loopThrough(places: Place[], hasCorners: boolean): PlanPoint[] {
  const around = isClockwise(places) ? places.toReversed() : places;
  const n = around.length;
  const direction = (k: number) => {
    const [a, b] = [around[k % n], around[(k + 1) % n]];
    return Math.atan2(b[1] - a[1], b[0] - a[0]);
  };
  const turn = (k: number) => {
    const by = direction(k) - direction(k + n - 1);
    return Math.atan2(Math.sin(by), Math.cos(by));
  };
  return around.map((at, k) => ({
    at,
    bulge: 0,
    corner: hasCorners && turn(k) > SHARP,
  }));
}
