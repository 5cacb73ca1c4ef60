/** The vertices of a scene, as a Rhino file has them. */

import type { Point } from './rhino-objects.ts';

/**
 * Returns the current shape of a scene with its mesh, with z up. A scene saved at its design has
 * no other positions than those of that variant.
 */
export function pointsOf({ mesh, variants, current, up }: any): Point[] {
  const points = current ?? variants?.kept[variants.design]?.positions ?? mesh.positions;
  return up === 'y' ? points.map(rotated) : points;
}

/** Rotates from y up to z up. */
const rotated = ([x, y, z]: Point): Point => [x, -z, y];
