/**
 * Converts a Rhino file to OBJ text. Meshes become faces, with one group per layer. Polylines
 * become curves, except that those exported from here as panels become faces; in a file without a
 * mesh, all closed polylines do. Coincident corners are welded: Rhino stores objects separately.
 */

import { NAMES, ROLE, rhino } from './rhino.ts';
import type { NamedBytes } from '../../solver/types.ts';

type Point = [number, number, number];
type Face = { layer: string; corners: Point[] };

/** Welding distance, relative to the size: many Rhino meshes store seven digits. */
const SAME = 1e-6;

export async function meshFromRhino({ name, bytes }: NamedBytes): Promise<NamedBytes> {
  const api = await rhino();
  const file = api.File3dm.fromByteArray(bytes);
  if (!file) throw new Error(`${name}: this is not a Rhino file, or it is damaged.`);
  try {
    const { faces, curves, others } = objectsOf(file);
    if (faces.length + curves.length === 0) {
      throw new Error(
        others > 0
          ? `${name} contains ${others} ${others === 1 ? 'object' : 'objects'} but no mesh or polyline. Convert surfaces with Rhino’s Mesh command.`
          : `${name} contains no mesh or polyline.`,
      );
    }
    const system = file.settings().modelUnitSystem;
    const units = Object.keys(NAMES).find((unit) => api.UnitSystem[NAMES[unit]] === system);
    const text = objText(faces, curves, units);
    return { name: name.replace(/\.3dm$/i, '.obj'), bytes: new TextEncoder().encode(text) };
  } finally {
    file.delete();
  }
}

/** Collects the faces and curves of the file, and counts the other objects. */
function objectsOf(file: any) {
  const faces: Face[] = [];
  const lines: (Face & { role: string | undefined })[] = [];
  let others = 0;
  const objects = file.objects();
  for (let i = 0; i < objects.count; i++) {
    const object = objects.get(i);
    const geometry = object.geometry();
    const attributes = object.attributes();
    const layer = layerName(file, attributes.layerIndex);
    if (geometry?.faces && geometry.vertices && !geometry.edges) {
      faces.push(...facesOf(geometry, layer));
    } else if (geometry?.isPolyline?.()) {
      const corners = cornersOf(geometry);
      lines.push({ layer, corners, role: attributes.getUserString(ROLE) || undefined });
    } else {
      others += 1;
    }
  }
  const hasMesh = faces.length > 0;
  const isPanel = ({ corners, role }: Face & { role: string | undefined }) =>
    isClosed(corners) && corners.length > 3 && (role ? role === 'panel' : !hasMesh);
  for (const line of lines.filter(isPanel)) {
    faces.push({ layer: line.layer, corners: line.corners.slice(0, -1) });
  }
  return { faces, curves: lines.filter((line) => !isPanel(line)), others };
}

function layerName(file: any, index: number): string {
  const layers = file.layers();
  return index >= 0 && index < layers.count ? layers.get(index).name : '';
}

function facesOf(mesh: any, layer: string): Face[] {
  const [vertices, faces] = [mesh.vertices(), mesh.faces()];
  return Array.from({ length: faces.count }, (_, i) => {
    const [a, b, c, d] = faces.get(i);
    // A triangle repeats its last corner.
    const corners = c === d ? [a, b, c] : [a, b, c, d];
    return { layer, corners: corners.map((vertex) => vertices.point3dAt(vertex)) };
  });
}

function cornersOf(polyline: any): Point[] {
  return Array.from({ length: polyline.pointCount }, (_, i) => polyline.point(i));
}

function isClosed(corners: Point[]) {
  const last = corners[corners.length - 1];
  return corners[0].every((x, axis) => x === last[axis]);
}

function objText(faces: Face[], curves: Face[], units: string | undefined) {
  const all = [...faces, ...curves].flatMap(({ corners }) => corners);
  const sides = [0, 1, 2].map((axis) => {
    const values = all.map((point) => point[axis]);
    const least = values.reduce((a, b) => Math.min(a, b), Infinity);
    return values.reduce((a, b) => Math.max(a, b), -Infinity) - least;
  });
  const numberOf = welded(SAME * Math.hypot(...sides));
  const lines = [];
  let layer = '';
  for (const face of faces) {
    if (face.layer !== layer) lines.push(`g ${face.layer.replace(/\s+/g, '_')}`);
    layer = face.layer;
    const numbers = face.corners.map(numberOf.of);
    // A corner equal to the one before it (after welding) is dropped.
    const distinct = numbers.filter((number, i) => number !== numbers.at(i - 1));
    lines.push(`f ${distinct.join(' ')}`);
  }
  if (curves.length > 0 && layer) lines.push('g');
  for (const curve of curves) lines.push(`l ${curve.corners.map(numberOf.of).join(' ')}`);
  const head = ['# up: z', ...(units ? [`# units: ${units}`] : [])];
  const vertices = numberOf.points.map((point) => `v ${point.join(' ')}`);
  return `${[...head, ...vertices, ...lines].join('\n')}\n`;
}

/** Numbers points from 1; points within `tolerance` share a number. */
function welded(tolerance: number) {
  const points: Point[] = [];
  const cells: Map<string, number[]> = new Map();
  const cell = tolerance || 1;
  function of(point: Point) {
    const home = point.map((x) => Math.floor(x / cell));
    for (const [dx, dy, dz] of NEIGHBOURS) {
      const key = `${home[0] + dx} ${home[1] + dy} ${home[2] + dz}`;
      for (const number of cells.get(key) ?? []) {
        const other = points[number - 1];
        if (Math.hypot(...point.map((x, axis) => x - other[axis])) <= tolerance) return number;
      }
    }
    points.push(point);
    const key = home.join(' ');
    cells.set(key, [...(cells.get(key) ?? []), points.length]);
    return points.length;
  }
  return { of, points };
}

const NEAR = [0, -1, 1];
const NEIGHBOURS = NEAR.flatMap((x) => NEAR.flatMap((y) => NEAR.map((z) => [x, y, z])));
