/** Layers of a Rhino file: one for each group name. */

import { indices } from './index-list.js';

/** @typedef {{ faces?: number[] | string }} Group */

/** Layer of the faces that are in no group. */
const REST = 'Panels';

/**
 * Returns the faces on each layer; a face in several groups is on the layer of the first.
 * @param {number} count number of faces
 * @param {Record<string, Group | Group[]>} groups of a scene; an array if several share a name
 */
export function byLayer(count, groups) {
  /** @type {(string | null)[]} */
  const layerOf = new Array(count).fill(null);
  for (const [name, sameName] of Object.entries(groups)) {
    for (const group of [sameName].flat()) {
      for (const face of indices(group.faces ?? [])) layerOf[face] ??= name;
    }
  }
  /** @type {Map<string, number[]>} */
  const layers = new Map();
  layerOf.forEach((name, face) => {
    const key = name ?? REST;
    const members = layers.get(key);
    if (members) members.push(face);
    else layers.set(key, [face]);
  });
  return layers;
}
