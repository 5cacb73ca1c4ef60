/**
 * The plane of a face, of which all corners but one are known: two coordinates of that one say the third, and what
 * the faces beside it do out of their planes says more.
 */

import { cross, dot, minus } from './vectors.js';

/** @typedef {import("./vectors.js").Vector} Vector */

/**
 * @param {Vector} p from one corner to the next
 * @param {Vector} q to the one before
 * @returns {{ axis: number, slopes: Vector } | null} the axis that leaves the plane fastest, and how far along it a point
 *   is off the plane by its distance along each axis; null where the corners are in a line
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
 * Where a point is along the axis of a plane, which its other coordinates say.
 * @param {NonNullable<ReturnType<typeof planeAlong>>} plane
 * @param {Vector} base a point in the plane
 * @param {Vector} at the point, whose coordinate along the axis is not looked at
 */
export function alongPlane({ axis, slopes }, base, at) {
  const off = minus(at, base);
  off[axis] = 0;
  return base[axis] - dot(slopes, off);
}
