/** The loops of a plan: their sides, straight or arcs, and what of them is drawn. */

/** @typedef {import("../../pkg/build/shape_up.js").PlanPoint} PlanPoint */
/** @typedef {[number, number]} Place */

/** Sharper turns than this are corners of what is drawn: 20 degrees. */
const SHARP = (20 * Math.PI) / 180;

/**
 * Whether the points go round clockwise. Of two points, whose arcs are all there is, both directions are the same.
 * @param {Place[]} places
 */
export function isClockwise(places) {
  const twice = (/** @type {Place} */ [x, y], /** @type {number} */ k) => {
    const [nextX, nextY] = places[(k + 1) % places.length];
    return x * nextY - nextX * y;
  };
  return places.reduce((sum, place, k) => sum + twice(place, k), 0) < 0;
}

/**
 * The side from a point to the next one: its chord, the unit direction outward, its middle.
 * @param {PlanPoint[]} points
 * @param {number} k
 */
export function sideOf(points, k) {
  const { at: from, bulge = 0 } = points[k];
  const { at: to } = points[(k + 1) % points.length];
  const along = [to[0] - from[0], to[1] - from[1]];
  const chord = Math.hypot(along[0], along[1]) || 1;
  const sign = isClockwise(points.map(({ at }) => at)) ? -1 : 1;
  const outward = [(sign * along[1]) / chord, (-sign * along[0]) / chord];
  const rise = (bulge * chord) / 2;
  /** @type {Place} */
  const middle = [
    (from[0] + to[0]) / 2 + rise * outward[0],
    (from[1] + to[1]) / 2 + rise * outward[1],
  ];
  return { from, to, along, chord, outward, rise, middle };
}

/**
 * The bulge of a side whose arc goes through a place nearest to its middle.
 * @param {PlanPoint[]} points
 * @param {number} k
 * @param {Place} through
 */
export function bulgeThrough(points, k, through) {
  const { from, to, outward, chord } = sideOf(points, k);
  const away = [through[0] - (from[0] + to[0]) / 2, through[1] - (from[1] + to[1]) / 2];
  return clamped((2 * (away[0] * outward[0] + away[1] * outward[1])) / chord);
}

/** Half circles are the most. @param {number} bulge */
export const clamped = (bulge) => Math.min(Math.max(bulge, -1), 1);

/**
 * A loop as the data of an SVG path, in the places that `onto` gives. There `y` points down.
 * @param {PlanPoint[]} points
 * @param {(place: Place) => Place} onto
 * @param {number} scale of `onto`
 */
export function pathOf(points, onto, scale) {
  const drawn = points.map((_, k) => lineTo(points, k, onto, scale));
  return `M${onto(points[0].at).join(' ')}${drawn.join('')}Z`;
}

/**
 * The side from a point to the next one, in the same way.
 * @param {PlanPoint[]} points
 * @param {number} k
 * @param {(place: Place) => Place} onto
 * @param {number} scale of `onto`
 */
export function sidePathOf(points, k, onto, scale) {
  return `M${onto(points[k].at).join(' ')}${lineTo(points, k, onto, scale)}`;
}

/**
 * The same from where the path is.
 * @param {PlanPoint[]} points
 * @param {number} k
 * @param {(place: Place) => Place} onto
 * @param {number} scale of `onto`
 */
function lineTo(points, k, onto, scale) {
  const { bulge = 0 } = points[k];
  const { to, chord } = sideOf(points, k);
  const end = onto(to).join(' ');
  if (Math.abs(bulge) < 1e-6) return `L${end}`;
  const radius = (scale * chord * (1 + bulge * bulge)) / (4 * Math.abs(bulge));
  // Downward y turns the direction around.
  const sweep = bulge > 0 === isClockwise(points.map(({ at }) => at)) ? 1 : 0;
  return `A${radius} ${radius} 0 0 ${sweep} ${end}`;
}

/**
 * The least and greatest coordinates of loops, with the middles of their arcs.
 * @param {PlanPoint[][]} loops
 */
export function extentOf(loops) {
  const places = loops.flatMap((points) =>
    points.flatMap(({ at }, k) => [at, sideOf(points, k).middle]),
  );
  const along = (/** @type {0 | 1} */ axis) => places.map((place) => place[axis]);
  return {
    low: /** @type {Place} */ ([Math.min(...along(0)), Math.min(...along(1))]),
    high: /** @type {Place} */ ([Math.max(...along(0)), Math.max(...along(1))]),
  };
}

/**
 * The step of a grid with about so many over a length: 1, 2 or 5 times a power of ten.
 * @param {number} length
 * @param {number} count
 */
export function roundStep(length, count) {
  const power = 10 ** Math.floor(Math.log10(length / count));
  return power * ([1, 2, 5].find((one) => one * power * count >= length) ?? 10);
}

/**
 * A drawn loop, counterclockwise, of which the sharp turns outward are corners, where it is to have some.
 * @param {Place[]} places
 * @param {boolean} hasCorners
 * @returns {PlanPoint[]}
 */
export function loopThrough(places, hasCorners) {
  const around = isClockwise(places) ? places.toReversed() : places;
  const n = around.length;
  const direction = (/** @type {number} */ k) => {
    const [a, b] = [around[k % n], around[(k + 1) % n]];
    return Math.atan2(b[1] - a[1], b[0] - a[0]);
  };
  const turn = (/** @type {number} */ k) => {
    const by = direction(k) - direction(k + n - 1);
    return Math.atan2(Math.sin(by), Math.cos(by));
  };
  return around.map((at, k) => ({
    at,
    bulge: 0,
    corner: hasCorners && turn(k) > SHARP,
  }));
}
