/** What of a scene goes into a Rhino file: the vertices as they are there, and one layer per group. */

import type { Groups, Point, SceneText } from '../../solver/scene-text.ts';

/**
 * Returns the current shape of a scene with its mesh, with z up. A scene saved at its design has
 * no other positions than those of that variant.
 */
export function pointsOf({ mesh, variants, current, up }: SceneText): Point[] {
  const design = variants?.kept?.[variants.design ?? -1];
  const points = current ?? design?.positions ?? mesh.positions;
  return up === 'y' ? points.map(rotated) : points;
}

/** Rotates from y up to z up. */
const rotated = ([x, y, z]: Point): Point => [x, -z, y];

/** Layer of the faces that are in no group. */
const REST = 'Panels';
/** Layer of the curves. */
const CURVES = 'Curves';

/** Returns a name that no group has. */
function free(name: string, groups: Groups) {
  let found = name;
  for (let n = 2; Object.hasOwn(groups, found); n++) found = `${name} ${n}`;
  return found;
}

export const curvesLayer = (groups: Groups) => free(CURVES, groups);

/**
 * Returns the faces on each layer; a face in several groups is on the layer of the first.
 * @param count number of faces
 */
export function byLayer(count: number, groups: Groups) {
  const rest = free(REST, groups);
  const layerOf: (string | null)[] = new Array(count).fill(null);
  for (const [name, sameName] of Object.entries(groups)) {
    for (const group of [sameName].flat()) {
      for (const face of indices(group.faces ?? [])) layerOf[face] ??= name;
    }
  }
  const layers: Map<string, number[]> = new Map();
  layerOf.forEach((name, face) => {
    const key = name ?? rest;
    const members = layers.get(key);
    if (members) members.push(face);
    else layers.set(key, [face]);
  });
  return layers;
}

/** Expands an index list of a scene file: an array, or ranges such as "0-3,7". */
export function indices(list: number[] | string): number[] {
  if (typeof list !== 'string') return list;
  if (list.trim() === '') return [];
  return list.split(',').flatMap((range) => {
    const [first, last = first] = range.split('-').map(Number);
    return Array.from({ length: last - first + 1 }, (_, i) => first + i);
  });
}
