/**
 * The faces and curves of a Rhino file as OBJ text. Coincident corners are welded: Rhino stores objects
 * separately.
 */

import type { Point } from '../../solver/scene-text.ts';
import type { Face, Line } from './rhino-objects.ts';

/** Upper bound on the welding distance, relative to the size: many Rhino meshes store seven digits. */
const SAME = 1e-6;
/** Upper bound on it relative to the shortest side, so that none vanishes, as where the engine welds. */
const OF_SHORTEST_SIDE = 0.1;
/** The key of corners that are welded wherever they coincide; objects are numbered from 0. */
const JOINED = -1;

/** @param units symbol of the unit of length, if there is one */
export function objText(faces: Face[], curves: Line[], units: string | undefined) {
  // Objects are in the order in which they were made, and each layer is named once.
  const layers: Map<string, Face[]> = new Map();
  for (const face of faces) {
    const name = nameOf(face.layer);
    layers.set(name, layers.get(name) ?? []);
    layers.get(name)?.push(face);
  }
  const sorted = [...layers.values()].flat();
  const tolerance = weldingDistance(faces, curves);
  let { rings, numberOf } = numbered(sorted, tolerance, () => JOINED);
  const apart = touching(sorted, rings);
  if (apart.size > 0) {
    const keyOf = ({ object }: Face) => (apart.has(object) ? object : JOINED);
    ({ rings, numberOf } = numbered(sorted, tolerance, keyOf));
  }
  const lines = [];
  let from = 0;
  for (const [name, { length }] of layers) {
    lines.push(`o ${name}`.trim());
    for (const numbers of rings.slice(from, from + length)) lines.push(`f ${numbers.join(' ')}`);
    from += length;
  }
  if (curves.length > 0) lines.push('o');
  for (const { corners } of curves)
    lines.push(`l ${corners.map((point) => numberOf.of(point)).join(' ')}`);
  const head = ['# up: z', ...(units ? [`# units: ${units}`] : [])];
  const vertices = numberOf.points.map((point) => `v ${point.join(' ')}`);
  return `${[...head, ...vertices, ...lines].join('\n')}\n`;
}

/** The name of a layer as OBJ has it: what separates its words is one space there. */
const nameOf = (layer: string) => layer.trim().split(/\s+/).join(' ');

/** Numbers the corners of faces: those at one place, in objects with the same key, have one number. */
function numbered(faces: Face[], tolerance: number, keyOf: (face: Face) => number) {
  const numberOf = welded(tolerance);
  const rings = faces.map((face) => {
    const numbers = face.corners.map((point) => numberOf.of(point, keyOf(face)));
    // A corner at the place of the one before it is dropped.
    return numbers.filter((number, i) => number !== numbers.at(i - 1));
  });
  return { rings, numberOf };
}

/**
 * Returns the objects that touch others with some of their faces, as solids on each other do: if they
 * were joined, edges would have four faces. An object whose faces are all in another one is a copy of
 * them, and no reason to keep anything apart.
 */
function touching(faces: Face[], rings: number[][]) {
  /** The objects that have a face, by its corners. */
  const owners: Map<string, Set<number>> = new Map();
  /** The faces of each object. */
  const objects: Map<number, Set<string>> = new Map();
  rings.forEach((corners, i) => {
    // No face: its corners were at one or two places.
    if (corners.length < 3) return;
    const { object } = faces[i];
    const face = corners.toSorted((a, b) => a - b).join();
    owners.set(face, (owners.get(face) ?? new Set()).add(object));
    objects.set(object, (objects.get(object) ?? new Set()).add(face));
  });
  const others = (face: string, object: number) =>
    [...(owners.get(face) ?? [])].filter((other) => other !== object);
  const copies: Set<number> = new Set();
  for (const [object, own] of objects) {
    const [first, ...rest] = own;
    const isCopyOf = (other: number) =>
      !copies.has(other) && rest.every((face) => owners.get(face)?.has(other));
    if (others(first, object).some(isCopyOf)) copies.add(object);
  }
  const touches = (face: string, object: number) =>
    others(face, object).some((other) => !copies.has(other));
  const apart: Set<number> = new Set();
  for (const [object, own] of objects)
    if (!copies.has(object) && [...own].some((face) => touches(face, object))) apart.add(object);
  return apart;
}

const distance = (a: Point, b: Point) => Math.hypot(...a.map((x, axis) => x - b[axis]));

function weldingDistance(faces: Face[], curves: Line[]) {
  const low: Point = [Infinity, Infinity, Infinity];
  const high: Point = [-Infinity, -Infinity, -Infinity];
  let shortest = Infinity;
  const closed = faces.map(({ corners }) => [corners[corners.length - 1], ...corners]);
  for (const corners of [...closed, ...curves.map(({ corners }) => corners)]) {
    corners.forEach((corner, i) => {
      shortest = Math.min(shortest, (i > 0 && distance(corners[i - 1], corner)) || Infinity);
      corner.forEach((x, axis) => {
        low[axis] = Math.min(low[axis], x);
        high[axis] = Math.max(high[axis], x);
      });
    });
  }
  return Math.min(SAME * distance(low, high), OF_SHORTEST_SIDE * shortest);
}

/** Numbers points from 1; those within `tolerance` share a number, unless they have different keys. */
function welded(tolerance: number) {
  const points: Point[] = [];
  const keys: (number | undefined)[] = [];
  const cells: Map<string, number[]> = new Map();
  const cell = tolerance || 1;
  function of(point: Point, key?: number) {
    const home = point.map((x) => Math.floor(x / cell));
    for (const [dx, dy, dz] of NEIGHBOURS) {
      const at = `${home[0] + dx} ${home[1] + dy} ${home[2] + dz}`;
      for (const number of cells.get(at) ?? []) {
        const isOther = key !== undefined && keys[number - 1] !== key;
        if (!isOther && distance(points[number - 1], point) <= tolerance) return number;
      }
    }
    keys.push(key);
    points.push(point);
    const at = home.join(' ');
    cells.set(at, [...(cells.get(at) ?? []), points.length]);
    return points.length;
  }
  return { of, points };
}

const NEAR = [0, -1, 1];
const NEIGHBOURS = NEAR.flatMap((x) => NEAR.flatMap((y) => NEAR.map((z) => [x, y, z])));
