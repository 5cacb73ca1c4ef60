/**
 * Converts a Rhino file to OBJ text. Meshes become faces, with one group per layer, named by its full
 * path. Polylines become curves, except that those exported from here as panels become faces; in a file
 * without a mesh, all closed polylines do. Coincident corners are welded: Rhino stores objects separately.
 */

import { count, rhinoUnit, unitsOfLength } from '../../ui/words.ts';
import { rhino, type Point } from './rhino.ts';
import { objectsOf, unreadWords, type Face, type Line } from './rhino-objects.ts';
import type { NamedBytes } from '../../solver/types.ts';

/** Welding distance, relative to the size: many Rhino meshes store seven digits. */
const SAME = 1e-6;

/** A mesh, and what of the Rhino file is not in it. */
export type FromRhino = NamedBytes & {
  /** how many objects are hidden or on layers that are off */
  hidden: number;
  /** a sentence for what cannot be read; empty if there is nothing */
  unread: string;
};

/** @param withHidden takes hidden objects and those on layers that are off */
export async function meshFromRhino(
  { name, bytes }: NamedBytes,
  withHidden: boolean,
): Promise<FromRhino> {
  const api = await rhino();
  const file = api.File3dm.fromByteArray(bytes);
  if (!file) throw new Error(`${name}: this is not a Rhino file, or it is damaged.`);
  try {
    const { faces: meshed, lines, leftOut } = objectsOf(api, file, withHidden);
    const { faces, curves } = withPanels(meshed, lines);
    const unread = unreadWords(leftOut);
    if (faces.length + curves.length === 0) {
      const hidden = count(leftOut.hidden, 'object is', 'objects are');
      throw new Error(
        [
          `${name} contains no mesh or polyline${leftOut.hidden > 0 ? ' that is shown' : ''}.`,
          leftOut.hidden > 0 && `${hidden} hidden or on a layer that is off: show them in Rhino.`,
          unread,
        ]
          .filter(Boolean)
          .join(' '),
      );
    }
    const system = file.settings().modelUnitSystem;
    const units = unitsOfLength().find((unit) => api.UnitSystem[rhinoUnit(unit) ?? ''] === system);
    const text = objText(faces, curves, units);
    return {
      name: name.replace(/\.3dm$/i, '.obj'),
      bytes: new TextEncoder().encode(text),
      hidden: leftOut.hidden,
      unread,
    };
  } finally {
    file.delete();
  }
}

/** Makes faces of the polylines that are panels; the others are curves. */
function withPanels(meshed: Face[], lines: Line[]) {
  const hasMesh = meshed.length > 0;
  const isPanel = ({ corners, role }: Line) =>
    isClosed(corners) && corners.length > 3 && (role ? role === 'panel' : !hasMesh);
  const panels = lines.filter(isPanel).map(({ layer, corners }) => ({
    layer,
    corners: corners.slice(0, -1),
  }));
  return { faces: [...meshed, ...panels], curves: lines.filter((line) => !isPanel(line)) };
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
