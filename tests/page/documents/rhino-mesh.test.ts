// The mesh that is made of the separate objects of a Rhino file.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText } from '../../../www/documents/rhino/rhino-mesh.ts';

type Place = [number, number, number];

/** A panel of one by one metre, a little off as in a mesh of seven digits. */
const panel = (x: number, y: number, off = 0) => ({
  layer: 'Roof',
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
