// How many faces a file has, by what is read of it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faceCountOf } from '../../../www/documents/face-count.ts';

/** The faces that are found in a file that comes in chunks of so many bytes. */
function counted(name: string, content: string | Uint8Array, step: number) {
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
  const count = faceCountOf({ name, size: bytes.length });
  for (let at = 0; at < bytes.length; at += step) count?.take(bytes.subarray(at, at + step));
  return count?.faces ?? null;
}

/** A binary STL file of so many facets, whose header may begin with "solid". */
function binaryStl(facets: number) {
  const bytes = new Uint8Array(84 + 50 * facets).fill(10);
  bytes.set(new TextEncoder().encode('solid made by a program'));
  new DataView(bytes.buffer).setUint32(80, facets, true);
  return bytes;
}

const FACET = 'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n';
const FILES: [name: string, content: string | Uint8Array, faces: number | null][] = [
  ['a.obj', '# faces\nv 0 0 0\nf 1 2 3\nf\t1 2 3\nvf 1\nf 3 2 1', 3],
  ['a.PLY', 'ply\nformat ascii 1.0\nelement vertex 3\nelement face 1234567\nend_header\n', 1234567],
  ['a.off', 'OFF # of a roof\n# 7 7\n12 345 0\n0 0 0\n', 345],
  ['a.off', 'COFF 12 345 0\n0 0 0\n', 345],
  ['a.off', '12 345 0\n0 0 0\n', 345],
  [
    'a.mesh',
    'Dimension 3\nVertices\n2\n0 0 0 0\nTriangles\n123\n1 2 3 0\nQuadrilaterals 45\n1 ',
    168,
  ],
  ['a.stl', binaryStl(300), 300],
  ['a.stl', `solid roof\n${`${FACET}endfacet\n`.repeat(20)}endsolid\n`, 20],
  ['a.3dm', 'unknown before it is converted', null],
];

test('the faces of every kind of file are known, however its bytes come', () => {
  // Those of OBJ files only were: of others, nothing was asked however large they were.
  for (const [name, content, faces] of FILES) {
    for (const step of [1, 7, 1000]) assert.equal(counted(name, content, step), faces, name);
  }
});
