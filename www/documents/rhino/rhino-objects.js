/** Adds layers, polylines and meshes to a Rhino file. */

/** @typedef {[number, number, number]} Point */

/**
 * @param {any} api
 * @param {any} file
 * @param {string} name
 * @param {[number, number, number]} [colour] red, green, blue
 * @returns {number} index of the layer
 */
export function addLayer(api, file, name, colour) {
  const layer = new api.Layer();
  layer.name = name;
  if (colour) {
    const [r, g, b] = colour;
    layer.color = { r, g, b, a: 255 };
  }
  const index = file.layers().add(layer);
  layer.delete();
  return index;
}

/**
 * Creates attributes: layer, user text and name. They are deleted when added with an object.
 * @param {any} api
 * @param {number} layer
 * @param {Record<string, string>} text user text
 * @param {string} [name]
 */
export function attributesOf(api, layer, text, name) {
  const attributes = new api.ObjectAttributes();
  attributes.layerIndex = layer;
  if (name) attributes.name = name;
  for (const [key, value] of Object.entries(text)) attributes.setUserString(key, value);
  return attributes;
}

/**
 * @param {any} api
 * @param {any} file
 * @param {Point[]} points
 * @param {any} attributes
 */
export function addPolyline(api, file, points, attributes) {
  const list = new api.Point3dList(points.length);
  for (const point of points) list.add(...point);
  file.objects().addPolyline(list, attributes);
  attributes.delete();
  list.delete();
}

/**
 * Adds a mesh; rhino3dm has no n-gons, so convex polygons of more than four corners become fans.
 * @param {any} api
 * @param {any} file
 * @param {{ points: Point[], faces: number[][] }} of
 * @param {any} attributes
 */
export function addMesh(api, file, { points, faces }, attributes) {
  const mesh = new api.Mesh();
  for (const point of points) mesh.vertices().addPoint3d(...point);
  for (const face of faces) {
    if (face.length === 4) mesh.faces().addQuadFace(...face);
    else
      for (let k = 2; k < face.length; k++) mesh.faces().addTriFace(face[0], face[k - 1], face[k]);
  }
  mesh.normals().computeNormals();
  file.objects().addMesh(mesh, attributes);
  attributes.delete();
  mesh.delete();
}
