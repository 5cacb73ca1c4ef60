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

/**
 * Faces of objects that touch, as of solids on each other, may coincide. The engine does not weld such
 * objects to each other (`mesh/edit/weld.rs`), and neither are they here.
 * @param units symbol of the unit of length, if there is one
 */
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
  let { rings, numberOf } = numbered(sorted, tolerance, () => 0);
  const count = different(rings);
  if (count < faces.length) {
    const apart = numbered(sorted, tolerance, ({ object }) => object);
    if (different(apart.rings) > count) ({ rings, numberOf } = apart);
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

/** Number of faces without those that coincide with others. */
const different = (faces: number[][]) =>
  new Set(faces.map((corners) => corners.toSorted((a, b) => a - b).join())).size;

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
