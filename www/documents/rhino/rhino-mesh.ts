/**
 * The faces and curves of a Rhino file as OBJ text. Coincident corners are welded: Rhino stores objects
 * separately.
 */

import type { Point } from '../../solver/scene-text.ts';
import type { Face } from './rhino-objects.ts';

/** Upper bound on the welding distance, relative to the size: many Rhino meshes store seven digits. */
const SAME = 1e-6;
/** Upper bound on it relative to the shortest side, so that none vanishes, as where the engine welds. */
const OF_SHORTEST_SIDE = 0.1;

/** @param units symbol of the unit of length, if there is one */
export function objText(faces: Face[], curves: Face[], units: string | undefined) {
  const numberOf = welded(weldingDistance(faces, curves));
  const lines = [];
  let layer = '';
  for (const face of faces) {
    if (face.layer !== layer) lines.push(`g ${face.layer.replace(/\s+/g, '_')}`);
    layer = face.layer;
    const numbers = face.corners.map(numberOf.of);
    // A corner at the place of the one before it is dropped.
    const distinct = numbers.filter((number, i) => number !== numbers.at(i - 1));
    lines.push(`f ${distinct.join(' ')}`);
  }
  if (curves.length > 0 && layer) lines.push('g');
  for (const curve of curves) lines.push(`l ${curve.corners.map(numberOf.of).join(' ')}`);
  const head = ['# up: z', ...(units ? [`# units: ${units}`] : [])];
  const vertices = numberOf.points.map((point) => `v ${point.join(' ')}`);
  return `${[...head, ...vertices, ...lines].join('\n')}\n`;
}

const distance = (a: Point, b: Point) => Math.hypot(...a.map((x, axis) => x - b[axis]));

function weldingDistance(faces: Face[], curves: Face[]) {
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

/** Numbers points from 1; points within `tolerance` share a number. */
function welded(tolerance: number) {
  const points: Point[] = [];
  const cells: Map<string, number[]> = new Map();
  const cell = tolerance || 1;
  function of(point: Point) {
    const home = point.map((x) => Math.floor(x / cell));
    for (const [dx, dy, dz] of NEIGHBOURS) {
      const key = `${home[0] + dx} ${home[1] + dy} ${home[2] + dz}`;
      for (const number of cells.get(key) ?? [])
        if (distance(points[number - 1], point) <= tolerance) return number;
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
