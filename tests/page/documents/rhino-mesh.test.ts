// The mesh that is made of the separate objects of a Rhino file.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText } from '../../../www/documents/rhino/rhino-mesh.ts';

type Place = [number, number, number];

/** A panel of one by one metre, a little off as in a mesh of seven digits. */
const panel = (x: number, y: number, off = 0) => ({
  ...{ layer: 'Roof', object: 1 },
  corners: [
    [x + off, y, 0],
    [x + 1, y, 0],
    [x + 1, y + 1, 0],
    [x + off, y + 1, 0],
  ] as Place[],
});

const facesOf = (text: string) => text.split('\n').filter((line) => line.startsWith('f '));

test('corners at one place up to rounding become one vertex', () => {
  const text = objText([panel(0, 0), panel(1, 0, 1e-7)], [], 'm');
  assert.deepEqual(facesOf(text), ['f 1 2 3 4', 'f 2 5 6 3']);
});

test('an object far away joins no corners of a panel', () => {
  // The welding distance was a part of the size of all: the whole roof became one vertex.
  const roof = [panel(500_000, 4_600_000), panel(500_001, 4_600_000)];
  const stray = { layer: '', corners: [[0, 0, 0] as Place, [0, 0, 1] as Place] };
  const text = objText(roof, [stray], 'm');
  assert.deepEqual(facesOf(text), ['f 1 2 3 4', 'f 2 5 6 3']);
});

test('the two ends of a curve that nearly meet are no side', () => {
  const loop: Place[] = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [1e-9, 0, 0],
  ];
  const text = objText([panel(0, 0), panel(1, 0, 1e-7)], [{ layer: '', corners: loop }], 'm');
  assert.deepEqual(facesOf(text), ['f 1 2 3 4', 'f 2 5 6 3']);
});

/** The faces of a box of one by one by one metre on the floor at z. */
const box = (z: number, object: number) =>
  [0, 1, 2, 3, 4, 5].map((face) => {
    const [a, b, c] = [face % 3, (face + 1) % 3, (face + 2) % 3];
    const corners = [0, 1, 3, 2].map((corner) => {
      const at: Place = [0, 0, z];
      at[a] += face < 3 ? 0 : 1;
      at[b] += corner & 1;
      at[c] += corner >> 1;
      return at;
    });
    return { layer: '', object, corners };
  });

const verticesOf = (faces: Parameters<typeof objText>[0]) =>
  objText(faces, [], 'm').match(/^v /gm)?.length;

test('boxes on each other stay two, and objects that only have an edge in common are joined', () => {
  // Edges had four faces, and the floor between the boxes was there twice.
  assert.equal(verticesOf([...box(0, 1), ...box(1, 2)]), 16);
  assert.equal(verticesOf([panel(0, 0), { ...panel(1, 0), object: 2 }]), 6);
});

test('a copy of an object, or of one of its faces, keeps nothing apart', () => {
  // One panel that was there twice left all the others of the roof without common vertices.
  const roof = [0, 1, 2].map((x) => ({ ...panel(x, 0), object: x + 1 }));
  assert.equal(verticesOf([...roof, { ...panel(1, 0), object: 4 }]), 8);
  assert.equal(verticesOf([panel(0, 0), panel(1, 0), { ...panel(0, 0), object: 2 }]), 6);
  assert.equal(verticesOf([...box(0, 1), ...box(0, 2)]), 8);
  // Boxes on each other stay two beside it, and the panels are joined beside them.
  const all = [...box(5, 7), ...roof, { ...panel(1, 0), object: 4 }, ...box(6, 8)];
  assert.equal(verticesOf(all), 24);
});

test('faces whose corners are at one or two places keep no objects apart', () => {
  // A roof in two objects was opened in two pieces, since both had a face without area at their seam.
  const [one, other] = [panel(0, 0), { ...panel(1, 0), object: 2 }];
  const at = (object: number, ...corners: Place[]) => ({ layer: '', object, corners });
  const seam: Place[] = [
    [1, 0, 0],
    [1, 1, 0],
  ];
  const slivers = [1, 2].map((object) => at(object, ...seam, seam[1]));
  const points = [1, 2].map((object) =>
    at(object, seam[object - 1], seam[object - 1], seam[object - 1]),
  );
  assert.equal(verticesOf([one, ...slivers, ...points, other]), 6);
});

test('a layer is named once, with its spaces, wherever its objects are in the file', () => {
  // A note said that one name stood for several groups, and "Roof A" was told as "Roof_A".
  const at = (x: number, layer: string) => ({ ...panel(x, 0), layer });
  const text = objText([at(0, 'Roof A'), at(1, 'Roof_A'), at(2, 'Roof A'), at(3, '')], [], 'm');
  const named = text.split('\n').filter((line) => /^[of]/.test(line));
  assert.deepEqual(
    named.map((line) => line.replace(/ [\d ]+$/, '')),
    ['o Roof A', 'f', 'f', 'o Roof_A', 'f', 'o', 'f'],
  );
});
