/**
 * Prediction from the plane of a face with one unknown corner: two coordinates of that corner
 * determine the third. The offsets of adjacent faces from their planes refine it.
 */

import { cross, dot, minus } from './vectors.js';

/** @typedef {import("./vectors.js").Vector} Vector */

/**
 * @param {Vector} p edge vector from a corner to the next
 * @param {Vector} q edge vector to the previous corner
 * @returns {{ axis: number, slopes: Vector } | null} the axis closest to the normal, and the normal
 *   divided by its component on that axis; null if the corners are collinear
 */
export function planeAlong(p, q) {
  const normal = cross(p, q);
  const sizes = normal.map(Math.abs);
  const most = Math.max(...sizes);
  if (!(most > 0)) return null;
  const axis = sizes.indexOf(most);
  const [x, y, z] = normal;
  return { axis, slopes: [x / normal[axis], y / normal[axis], z / normal[axis]] };
}

/**
 * Returns the coordinate of the plane along its axis, at a point's other two coordinates.
 * @param {NonNullable<ReturnType<typeof planeAlong>>} plane
 * @param {Vector} base a point in the plane
 * @param {Vector} at the point; its coordinate along the axis is ignored
 */
export function alongPlane({ axis, slopes }, base, at) {
  const off = minus(at, base);
  off[axis] = 0;
  return base[axis] - dot(slopes, off);
}
