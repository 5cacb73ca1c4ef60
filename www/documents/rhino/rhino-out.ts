/**
 * Writes a scene as a Rhino file, in full precision. Each group of faces becomes a layer. Triangles
 * and quads form a mesh on it; panels with more corners, which rhino3dm cannot write into a mesh, and
 * faces that are left as they are become closed polylines. The user text gives the planarity distance
 * of a panel, or the largest one of a mesh. Rhino's vertical axis is z: a scene with y up is rotated.
 * Also writes the parts to be built: named objects on coloured layers.
 */

import { rhinoUnit } from '../../ui/words.ts';
import { addMesh, addPolyline, attributesOf, layersIn, rhino } from './rhino.ts';
import { ROLE } from './rhino-objects.ts';
import { byLayer, curvesLayer, pointsOf } from './scene-lists.ts';
import { sceneOf, type Point } from '../../solver/scene-text.ts';
import type { SpatialPart } from '../../pkg/engine/shape_up.js';

const PLANARITY = 'shape-up:planarity';

/**
 * Writes a file.
 * @param symbol unit of its coordinates
 * @param fill adds its objects, on layers by their names
 */
async function written(
  symbol: string,
  fill: (api: any, file: any, layerAt: ReturnType<typeof layersIn>) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const api = await rhino();
  const file = new api.File3dm();
  try {
    file.settings().modelUnitSystem = api.UnitSystem[rhinoUnit(symbol) ?? 'None'];
    file.applicationName = 'Shape-Up';
    fill(api, file, layersIn(api, file));
    return file.toByteArray();
  } finally {
    file.delete();
  }
}

/**
 * @param text scene with its mesh
 * @param errors table of face errors from the solver (CSV)
 */
export async function rhinoFile(text: string, errors: string): Promise<Uint8Array<ArrayBuffer>> {
  const scene = sceneOf(text);
  const { units = '', mesh } = scene;
  const { faces: own = [], untouched = [], curves = [], groups = {} } = mesh;
  const faces = [...own, ...untouched];
  if (faces.length + curves.length === 0)
    throw new Error('There are no faces or curves, which a Rhino file is made of.');
  const points = pointsOf(scene);
  const distances = planarities(errors);
  const inWords = (value: number) => `${value} ${units}`.trim();

  return written(units, (api, file, layerAt) => {
    for (const [name, members] of byLayer(faces.length, groups)) {
      const layer = layerAt(name);
      const isLine = (face: number) => face >= own.length || faces[face].length > 4;
      const meshed = members.filter((face) => !isLine(face));
      addPanels(api, file, layer, meshed, faces, points, inWords, distances);
      for (const face of members.filter(isLine)) {
        const corners = faces[face];
        const planarity = face < own.length && { [PLANARITY]: inWords(distances[face]) };
        const text = { [ROLE]: 'panel', ...planarity };
        const loop = [...corners, corners[0]].map((vertex) => points[vertex]);
        addPolyline(api, file, loop, attributesOf(api, layer, text));
      }
    }
    if (curves.length > 0) {
      const layer = layerAt(curvesLayer(groups));
      for (const curve of curves) {
        const line = curve.map((vertex) => points[vertex]);
        addPolyline(api, file, line, attributesOf(api, layer, { [ROLE]: 'curve' }));
      }
    }
  });
}

/** Reads the planarity distance of each face. */
function planarities(csv: string) {
  const [head, ...rows] = csv.trim().split('\n');
  const heads = head.split(',');
  // Counted from the right, since a group name may contain commas.
  const fromRight = heads.length - heads.findIndex((name) => /^Planarity( \(|$)/.test(name));
  return rows.map((row) => Number(row.split(',').at(-fromRight)));
}

/**
 * Adds triangles and quads as one mesh.
 * @param planarity formats a distance
 */
function addPanels(
  api: any,
  file: any,
  layer: number,
  flat: number[],
  faces: number[][],
  points: Point[],
  planarity: (worst: number) => string,
  distances: number[],
) {
  if (flat.length === 0) return;
  const localIndex: Map<number, number> = new Map();
  for (const vertex of flat.flatMap((face) => faces[face]))
    if (!localIndex.has(vertex)) localIndex.set(vertex, localIndex.size);
  const own = [...localIndex.keys()].map((vertex) => points[vertex]);
  const corners = flat.map((face) => faces[face].map((vertex) => localIndex.get(vertex) ?? 0));
  const worst = flat.reduce((most, face) => Math.max(most, distances[face]), 0);
  const text = { [PLANARITY]: planarity(worst) };
  addMesh(api, file, { points: own, faces: corners }, attributesOf(api, layer, text));
}

/**
 * Writes the parts to be built.
 * @param symbol unit of their coordinates
 */
export const rhinoParts = (parts: SpatialPart[], symbol: string) =>
  written(symbol, (api, file, layerAt) => {
    for (const { layer, colour, name, points, faces, closed } of parts) {
      const attributes = attributesOf(api, layerAt(layer, colour), {}, name);
      if (faces.length > 0) addMesh(api, file, { points, faces }, attributes);
      else addPolyline(api, file, closed ? [...points, points[0]] : points, attributes);
    }
  });
