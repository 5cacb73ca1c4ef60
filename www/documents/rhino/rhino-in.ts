/**
 * Converts a Rhino file to OBJ text. Meshes become faces, with one group per layer, named by its full
 * path. Polylines become curves, except that those exported from here as panels become faces; in a file
 * without a mesh, all closed polylines do.
 */

import { count, rhinoUnit, unitsOfLength } from '../../ui/words.ts';
import { rhino } from './rhino.ts';
import { objText } from './rhino-mesh.ts';
import { objectsOf, unreadWords, type Face, type Line } from './rhino-objects.ts';
import type { Point } from '../../solver/scene-text.ts';
import type { NamedBytes } from '../../solver/types.ts';

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
  // Together they are one object.
  const panels = lines.filter(isPanel).map(({ layer, corners }) => ({
    ...{ layer, object: 0 },
    corners: corners.slice(0, -1),
  }));
  return { faces: [...meshed, ...panels], curves: lines.filter((line) => !isPanel(line)) };
}

function isClosed(corners: Point[]) {
  const last = corners[corners.length - 1];
  return corners[0].every((x, axis) => x === last[axis]);
}
