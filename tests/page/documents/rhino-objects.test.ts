// What is taken of a Rhino file: blocks at their places, what is shown, full paths of layers; and what
// is said of the rest. The files are made with Rhino's own library.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import rhino3dm from 'rhino3dm';
import { objectsOf, unreadWords } from '../../../www/documents/rhino/rhino-objects.ts';

const api: any = await rhino3dm();
type Place = [number, number, number];

function square() {
  const mesh = new api.Mesh();
  const corners = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
  ];
  for (const corner of corners) mesh.vertices().addPoint3d(...corner);
  mesh.faces().addQuadFace(0, 1, 2, 3);
  return mesh;
}

function attributes(layerIndex = 0, visible = true) {
  const own = new api.ObjectAttributes();
  own.layerIndex = layerIndex;
  own.visible = visible;
  return own;
}

/** Adds a layer and returns its index. */
function addLayer(file: any, name: string, parent?: number, visible = true): number {
  const layer = new api.Layer();
  layer.name = name;
  layer.visible = visible;
  if (parent !== undefined) layer.parentLayerId = file.layers().get(parent).id;
  return file.layers().add(layer);
}

/** An instance of a block at a place, mirrored in x or not. */
function instance(file: any, block: number, [x, y, z]: Place, mirrored = false) {
  const xform = new api.Transform(1);
  Object.assign(xform, { m03: x, m13: y, m23: z, m00: mirrored ? -1 : 1 });
  return new api.InstanceReference(file.instanceDefinitions().get(block).id, xform);
}

const addBlock = (file: any, name: string, parts: any[], own = parts.map(() => attributes())) =>
  file.instanceDefinitions().add(name, '', '', '', [0, 0, 0], parts, own);

const addInstance = (file: any, reference: any, own = attributes()) =>
  file.objects().addInstanceObject(reference, own);

/** Writes the file and takes its objects. */
function taken(file: any, withHidden = false) {
  const written = api.File3dm.fromByteArray(file.toByteArray());
  return objectsOf(api, written, withHidden);
}

const firsts = (faces: { corners: Place[] }[]) => faces.map(({ corners }) => corners[0]);

test('instances of blocks are placed, nested and mirrored ones too, and the blocks are not', () => {
  const file = new api.File3dm();
  addLayer(file, 'Roof');
  const panel = addBlock(file, 'Panel', [square()]);
  const far: Place = [2_700_000.125, 1, 5];
  addInstance(file, instance(file, panel, far));
  const pair = addBlock(file, 'Pair', [
    instance(file, panel, [10, 0, 0]),
    instance(file, panel, [20, 0, 0], true),
  ]);
  addInstance(file, instance(file, pair, [0, 0, 3]));
  const { faces, leftOut } = taken(file);
  // In double precision.
  assert.deepEqual(faces[0].corners[0], far);
  assert.equal(faces.length, 3);
  assert.deepEqual(faces[1].corners, [
    [10, 0, 3],
    [11, 0, 3],
    [11, 1, 3],
    [10, 1, 3],
  ]);
  // The mirrored one runs the same way round.
  assert.deepEqual(faces[2].corners, [
    [20, 1, 3],
    [19, 1, 3],
    [19, 0, 3],
    [20, 0, 3],
  ]);
  assert.deepEqual(leftOut, { hidden: 0, surfaces: 0, curves: 0, links: 0, others: 0 });
});

test('lines and curves of straight parts are polylines, and a mirrored one runs the same way', () => {
  const file = new api.File3dm();
  addLayer(file, 'Roof');
  const [a, b, c]: Place[] = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 2, 0],
  ];
  file.objects().addLine(a, c);
  const straight = new api.PolylineCurve([a, b, c]);
  file.objects().addCurve(straight, attributes());
  file.objects().addCurve(straight.toNurbsCurve(), attributes());
  const block = addBlock(file, 'Line', [straight]);
  addInstance(file, instance(file, block, [5, 0, 0], true));
  const { lines, leftOut } = taken(file);
  assert.deepEqual(
    lines.map(({ corners }) => corners),
    [
      [a, c],
      [a, b, c],
      [a, b, c],
      [
        [4, 2, 0],
        [4, 0, 0],
        [5, 0, 0],
      ],
    ],
  );
  assert.equal(leftOut.curves, 0);
});

test('a block that is in itself twice is left out', () => {
  const file = new api.File3dm();
  const block = addBlock(file, 'Panel', [square()]);
  addInstance(file, instance(file, block, [0, 0, 0]));
  // No program writes such a file, so the list of parts is a false one.
  const written = api.File3dm.fromByteArray(file.toByteArray());
  const [definition, objects] = [written.instanceDefinitions().get(0), written.objects()];
  const ids = Array.from({ length: objects.count }, (_, i) => objects.get(i)).map(
    (object) => object.attributes().id,
  );
  const circular = {
    objects: () => objects,
    layers: () => written.layers(),
    instanceDefinitions: () => ({
      count: 1,
      get: () => ({ id: definition.id, getObjectIds: () => [...ids, ...ids] }),
    }),
  };
  const { faces, leftOut } = objectsOf(api, circular, false);
  assert.equal(faces.length, 2);
  assert.equal(leftOut.links, 2);
});

test('what is hidden or on a layer that is off is counted, and taken if asked for', () => {
  const file = new api.File3dm();
  addLayer(file, 'Shown');
  const off = addLayer(file, 'Off', undefined, false);
  const below = addLayer(file, 'Below', off);
  file.objects().addMesh(square(), attributes());
  file.objects().addMesh(square(), attributes(0, false));
  file.objects().addMesh(square(), attributes(off));
  file.objects().addMesh(square(), attributes(below));
  const shown = taken(file);
  assert.equal(shown.faces.length, 1);
  assert.equal(shown.leftOut.hidden, 3);
  const all = taken(file, true);
  assert.equal(all.faces.length, 4);
  assert.equal(all.leftOut.hidden, 0);
});

test('layers of one name below different ones stay apart', () => {
  const file = new api.File3dm();
  const [north, south] = [addLayer(file, 'North'), addLayer(file, 'South')];
  for (const parent of [north, south]) {
    file.objects().addMesh(square(), attributes(addLayer(file, 'Panels', parent)));
  }
  const layers = taken(file).faces.map(({ layer }) => layer);
  assert.deepEqual(layers, ['North::Panels', 'South::Panels']);
});

test('what cannot be read is counted by kind, with advice', () => {
  const file = new api.File3dm();
  addLayer(file, 'Roof');
  file.objects().addMesh(square(), attributes());
  file.objects().addSphere(new api.Sphere([0, 0, 0], 1), attributes());
  file.objects().addCircle(new api.Circle([0, 0, 0], 2), attributes());
  file.objects().addPoint([1, 2, 3], attributes());
  const { faces, leftOut } = taken(file);
  assert.deepEqual(firsts(faces as any), [[0, 0, 0]]);
  assert.deepEqual(leftOut, { hidden: 0, surfaces: 1, curves: 1, links: 0, others: 1 });
  assert.equal(
    unreadWords(leftOut),
    '1 surface or solid was left out: convert with Rhino’s Mesh or QuadRemesh command. ' +
      '1 curve was left out: convert with Rhino’s Convert command to polylines. ' +
      '1 other object was left out: points, text, dimensions and lights are not read.',
  );
  assert.equal(unreadWords({ hidden: 4, surfaces: 0, curves: 0, links: 0, others: 0 }), '');
});
