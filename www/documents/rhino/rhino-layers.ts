/** Layers of a Rhino file: one for each group name. */

import { indices } from './index-list.ts';

type Group = { faces?: number[] | string };

/** Layer of the faces that are in no group. */
const REST = 'Panels';

/**
 * Returns the faces on each layer; a face in several groups is on the layer of the first.
 * @param count number of faces
 * @param groups of a scene; an array if several share a name
 */
export function byLayer(count: number, groups: Record<string, Group | Group[]>) {
  const layerOf: (string | null)[] = new Array(count).fill(null);
  for (const [name, sameName] of Object.entries(groups)) {
    for (const group of [sameName].flat()) {
      for (const face of indices(group.faces ?? [])) layerOf[face] ??= name;
    }
  }
  const layers: Map<string, number[]> = new Map();
  layerOf.forEach((name, face) => {
    const key = name ?? REST;
    const members = layers.get(key);
    if (members) members.push(face);
    else layers.set(key, [face]);
  });
  return layers;
}
