/** The layers of a file of Rhino: one for each name of a group of faces. */

import { indices } from './index-list.js';

/** @typedef {{ faces?: number[] | string }} Group */

/** Of faces that are in no group. */
const REST = 'Panels';

/**
 * The faces on each layer; one that is in several groups is on the layer of the first.
 * @param {number} count of faces
 * @param {Record<string, Group | Group[]>} groups of a scene: where several have one name, an array of them
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
