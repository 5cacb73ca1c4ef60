/** Writes the parts to be built as a Rhino file: named objects on coloured layers. */

import { NAMES, rhino } from './rhino.ts';
import { addLayer, addMesh, addPolyline, attributesOf } from './rhino-objects.ts';
import type { SpatialPart } from '../../solver/types.ts';

/** @param symbol unit of their coordinates */
export async function rhinoParts(
  parts: SpatialPart[],
  symbol: string,
): Promise<Uint8Array<ArrayBuffer>> {
  const api = await rhino();
  const file = new api.File3dm();
  const layers: Map<string, number> = new Map();
  try {
    file.settings().modelUnitSystem = api.UnitSystem[NAMES[symbol] ?? 'None'];
    file.applicationName = 'Shape-Up';
    for (const { layer, colour, name, points, faces, closed } of parts) {
      const index = layers.get(layer) ?? addLayer(api, file, layer, colour);
      layers.set(layer, index);
      const attributes = attributesOf(api, index, {}, name);
      if (faces.length > 0) addMesh(api, file, { points, faces }, attributes);
      else addPolyline(api, file, closed ? [...points, points[0]] : points, attributes);
    }
    return file.toByteArray();
  } finally {
    file.delete();
  }
}
