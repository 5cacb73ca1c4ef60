/**
 * The objects of a Rhino file that are geometry for a mesh: its meshes and polylines, also those in
 * instances of blocks, which may be nested, at their places. Hidden objects and those on layers that are
 * off are left out, unless they are asked for; they are counted, and so is what cannot be read.
 */

import { count } from '../../ui/words.ts';
import type { Point } from '../../solver/scene-text.ts';

/** A face of a mesh; `object` tells the objects of the file and of blocks apart. */
export type Face = { layer: string; object: number; corners: Point[] };
export type Line = { layer: string; corners: Point[]; role?: string };

/** What is in a file besides its meshes and polylines. */
export interface LeftOut {
  /** objects that are hidden or on a layer that is off */
  hidden: number;
  /** surfaces and solids */
  surfaces: number;
  /** curves that are no polylines */
  curves: number;
  /** instances of blocks whose geometry is in another file */
  links: number;
  /** points, text, dimensions, lights, ... */
  others: number;
}

/** Key of the user text that gives the role of a polyline. */
export const ROLE = 'shape-up';

/** Layers in layers, at most this many; more are a circle. */
const DEEPEST = 64;

/** Rows of a transformation in space. */
type Transform = number[][];

const UNCHANGED: Transform = [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
];

/** @param withHidden takes hidden objects and those on layers that are off */
export function objectsOf(api: any, file: any, withHidden: boolean) {
  const faces: Face[] = [];
  const lines: Line[] = [];
  /** Number of objects so far. */
  let taken = 0;
  const leftOut: LeftOut = { hidden: 0, surfaces: 0, curves: 0, links: 0, others: 0 };
  /** Surfaces and solids with the transformation of their place. */
  const surfaces: { geometry: any; layer: string; to: Transform }[] = [];
  const layers = layersOf(file);
  const objects = itemsOf(file.objects());
  const byId = new Map(objects.map((object) => [object.attributes().id, object]));
  const definitions = new Map(
    itemsOf(file.instanceDefinitions()).map((definition) => [definition.id, definition]),
  );

  /** @param meshes of one object */
  function addFaces(meshes: any[], layer: string, to: Transform) {
    const object = ++taken;
    for (const mesh of meshes)
      for (const corners of facesOf(mesh, to)) faces.push({ layer, object, corners });
  }

  /** @param within the blocks that the object is in */
  function take(object: any, to: Transform, within: string[]) {
    const geometry = object.geometry();
    const attributes = object.attributes();
    const layer = layers(attributes.layerIndex);
    if (!withHidden && !(attributes.visible && layer.isOn)) {
      leftOut.hidden += 1;
      return;
    }
    const corners = cornersOf(geometry);
    if (geometry instanceof api.Mesh) {
      addFaces([geometry], layer.path, to);
    } else if (geometry instanceof api.InstanceReference) {
      const block: string = geometry.parentIdefId;
      const parts = definitions.get(block)?.getObjectIds() ?? [];
      const found = parts.flatMap((id: string) => byId.get(id) ?? []);
      // A block in itself would have no end.
      if (found.length === 0 || within.includes(block)) leftOut.links += 1;
      else {
        const place = after(to, matrix(geometry.xform));
        for (const part of found) take(part, place, [...within, block]);
      }
    } else if (corners.length > 1) {
      const role = attributes.getUserString(ROLE) || undefined;
      lines.push({ layer: layer.path, corners: placed(corners, to), role });
    } else if (isSurface(api, geometry)) {
      surfaces.push({ geometry, layer: layer.path, to });
    } else {
      leftOut[geometry instanceof api.Curve ? 'curves' : 'others'] += 1;
    }
  }

  for (const object of objects) {
    if (!object.attributes().isInstanceDefinitionObject) take(object, UNCHANGED, []);
  }
  // A mesh beside surfaces is most often made of them, and would be there twice.
  const isAlone = faces.length + lines.length === 0;
  for (const { geometry, layer, to } of surfaces) {
    const drawn = isAlone ? renderMeshes(api, geometry) : [];
    if (drawn.length === 0) leftOut.surfaces += 1;
    addFaces(drawn, layer, to);
  }
  return { faces, lines, leftOut };
}

/** Says what cannot be read, and what to do in Rhino. */
export function unreadWords({ surfaces, curves, links, others }: LeftOut) {
  const advice: [number, string, string, string][] = [
    [
      surfaces,
      'surface or solid was left out',
      'surfaces and solids were left out',
      'convert with Rhino’s Mesh or QuadRemesh command',
    ],
    [
      curves,
      'curve was left out',
      'curves were left out',
      'convert with Rhino’s Convert command to polylines',
    ],
    [
      links,
      'instance of a linked or empty block was left out',
      'instances of linked or empty blocks were left out',
      'embed the blocks with Rhino’s BlockManager',
    ],
    [
      others,
      'other object was left out',
      'other objects were left out',
      'points, text, dimensions and lights are not read',
    ],
  ];
  return advice
    .filter(([number]) => number > 0)
    .map(([number, one, many, advised]) => `${count(number, one, many)}: ${advised}.`)
    .join(' ');
}

function itemsOf(table: any): any[] {
  return Array.from({ length: table.count }, (_, i) => table.get(i));
}

/** Returns a function from the index of a layer to its full path, and whether it and those above are on. */
function layersOf(file: any) {
  const layers = itemsOf(file.layers());
  const byId = new Map(layers.map((layer) => [layer.id, layer]));
  const isOn = (layer: any, depth: number): boolean => {
    const parent = byId.get(layer.parentLayerId);
    return layer.visible && (!parent || depth > DEEPEST || isOn(parent, depth + 1));
  };
  return (index: number): { path: string; isOn: boolean } => {
    const layer = layers[index];
    if (!layer) return { path: '', isOn: true };
    return { path: layer.fullPath || layer.name, isOn: isOn(layer, 0) };
  };
}

const isSurface = (api: any, geometry: any) =>
  [api.Brep, api.Extrusion, api.Surface, api.SubD].some((kind) => kind && geometry instanceof kind);

/** The meshes that Rhino has drawn a surface or solid with, if they are in the file. */
function renderMeshes(api: any, geometry: any): any[] {
  const type = api.MeshType.Any;
  if (geometry instanceof api.Brep) {
    return itemsOf(geometry.faces()).flatMap((face) => face.getMesh(type) ?? []);
  }
  return geometry instanceof api.Extrusion ? [geometry.getMesh(type)].filter(Boolean) : [];
}

/** Reads a transformation in double precision. */
const matrix = (xform: any): Transform =>
  [0, 1, 2].map((row) => [0, 1, 2, 3].map((column) => xform[`m${row}${column}`]));

/** The transformation `first`, then `then`. */
const after = (then: Transform, first: Transform): Transform =>
  then.map((row) =>
    [0, 1, 2, 3].map((column) => {
      const own = [0, 1, 2].reduce((sum, k) => sum + row[k] * first[k][column], 0);
      return column === 3 ? own + row[3] : own;
    }),
  );

function moved([x, y, z]: Point, to: Transform): Point {
  if (to === UNCHANGED) return [x, y, z];
  const at = ([a, b, c, d]: number[]) => a * x + b * y + c * z + d;
  return [at(to[0]), at(to[1]), at(to[2])];
}

/** Whether a transformation mirrors. */
function mirrors([a, b, c]: Transform) {
  const minor = (i: number, j: number) => b[i] * c[j] - b[j] * c[i];
  return a[0] * minor(1, 2) - a[1] * minor(0, 2) + a[2] * minor(0, 1) < 0;
}

/** Moves corners. If they are mirrored, they run the other way round: a face would show its back. */
function placed(corners: Point[], to: Transform): Point[] {
  const there = corners.map((point) => moved(point, to));
  return mirrors(to) ? there.toReversed() : there;
}

function facesOf(mesh: any, to: Transform): Point[][] {
  const [vertices, faces] = [mesh.vertices(), mesh.faces()];
  return Array.from({ length: faces.count }, (_, i) => {
    const [a, b, c, d] = faces.get(i);
    // A triangle repeats its last corner.
    const own = c === d ? [a, b, c] : [a, b, c, d];
    const corners: Point[] = own.map((vertex) => vertices.point3dAt(vertex));
    return placed(corners, to);
  });
}

/** The corners of a polyline, a line, or a curve of straight parts; none of other objects. */
function cornersOf(geometry: any): Point[] {
  const polyline = geometry?.isPolyline?.() ? geometry.tryGetPolyline() : null;
  return Array.from({ length: polyline?.count ?? 0 }, (_, i) => polyline.get(i));
}
