/**
 * rhino3dm, McNeel's reader and writer of Rhino files, and the objects that it adds to them: layers,
 * polylines, meshes. It is larger than the rest of the page, so its own worker (`rhino-worker.ts`)
 * loads it when a Rhino file is read or written.
 */

import open from 'rhino3dm/rhino3dm.module.min.js';
import module from 'rhino3dm/rhino3dm.wasm?url';
import type { Point } from '../../solver/scene-text.ts';

export function rhino(): Promise<any> {
  return open({ locateFile: () => module }).catch((error: unknown) => {
    throw new Error('The .3dm converter could not be loaded. Check the network.', {
      cause: error,
    });
  });
}

/**
 * Returns a function from the full path of a layer, such as `Roof::North`, to its index, which adds what
 * is missing of it, with a colour: red, green, blue.
 */
export function layersIn(api: any, file: any) {
  const known: Map<string, number> = new Map();
  return function at(path: string, colour?: [number, number, number]): number {
    const before = known.get(path);
    if (before !== undefined) return before;
    const [, above, name] = /^(.+)::(.+)$/.exec(path) ?? [path, '', path];
    const layer = new api.Layer();
    layer.name = name;
    if (above) layer.parentLayerId = file.layers().get(at(above)).id;
    if (colour) {
      const [r, g, b] = colour;
      layer.color = { r, g, b, a: 255 };
    }
    const index: number = file.layers().add(layer);
    layer.delete();
    known.set(path, index);
    return index;
  };
}

/**
 * Creates attributes: layer, user text and name. They are deleted when added with an object.
 * @param text user text
 */
export function attributesOf(api: any, layer: number, text: Record<string, string>, name?: string) {
  const attributes = new api.ObjectAttributes();
  attributes.layerIndex = layer;
  if (name) attributes.name = name;
  for (const [key, value] of Object.entries(text)) attributes.setUserString(key, value);
  return attributes;
}

export function addPolyline(api: any, file: any, points: Point[], attributes: any) {
  const list = new api.Point3dList(points.length);
  for (const point of points) list.add(...point);
  file.objects().addPolyline(list, attributes);
  attributes.delete();
  list.delete();
}

/** Adds a mesh of triangles and quads: rhino3dm has no polygons of more corners. */
export function addMesh(
  api: any,
  file: any,
  { points, faces }: { points: Point[]; faces: number[][] },
  attributes: any,
) {
  const mesh = new api.Mesh();
  for (const point of points) mesh.vertices().addPoint3d(...point);
  for (const face of faces) {
    if (face.length === 4) mesh.faces().addQuadFace(...face);
    else mesh.faces().addTriFace(...face);
  }
  mesh.normals().computeNormals();
  file.objects().addMesh(mesh, attributes);
  attributes.delete();
  mesh.delete();
}
