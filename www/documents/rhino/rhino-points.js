/** The vertices of a scene, as a Rhino file has them. */

/** @typedef {import("./rhino-objects.js").Point} Point */

/**
 * Returns the current shape of a scene with its mesh, with z up. A scene saved at its design has
 * no other positions than those of that variant.
 * @param {any} scene
 * @returns {Point[]}
 */
export function pointsOf({ mesh, variants, current, up }) {
  const points = current ?? variants?.kept[variants.design]?.positions ?? mesh.positions;
  return up === 'y' ? points.map(rotated) : points;
}

/** Rotates from y up to z up. @param {Point} point @returns {Point} */
const rotated = ([x, y, z]) => [x, -z, y];
