/**
 * Prediction from the plane of a face with one unknown corner: two coordinates of that corner
 * determine the third. The offsets of adjacent faces from their planes refine it.
 */

import { cross, dot, minus, type Vector } from './vectors.ts';

/**
 * @param p edge vector from a corner to the next
 * @param q edge vector to the previous corner
 * @returns the axis closest to the normal, and the normal
 *   divided by its component on that axis; null if the corners are collinear
 */
export function planeAlong(p: Vector, q: Vector): { axis: number; slopes: Vector } | null {
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
 * @param base a point in the plane
 * @param at the point; its coordinate along the axis is ignored
 */
export function alongPlane(
  { axis, slopes }: NonNullable<ReturnType<typeof planeAlong>>,
  base: Vector,
  at: Vector,
) {
  const off = minus(at, base);
  off[axis] = 0;
  return base[axis] - dot(slopes, off);
}
