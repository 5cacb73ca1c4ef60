// Small pictures of shapes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drawShape } from '../../../www/ui/plot/thumbnail.ts';

/** The corners of the faces that are drawn, in pixels. */
function drawn(positions: number[]) {
  const corners: number[] = [];
  const context = {
    ...{ beginPath() {}, closePath() {}, fill() {}, stroke() {} },
    lineTo: (x: number, y: number) => corners.push(x, y),
  };
  const style = { color: 'rgb(1, 2, 3)' };
  globalThis.getComputedStyle = (() => style) as unknown as typeof getComputedStyle;
  const canvas = { clientWidth: 100, clientHeight: 100, style: {}, getContext: () => context };
  const mesh = { faceOffsets: Uint32Array.of(0, 4), faceIndices: Uint32Array.of(0, 1, 2, 3) };
  drawShape(canvas as unknown as HTMLCanvasElement, mesh, positions, { up: 'z' });
  return corners.map((value) => Math.round(value));
}

const SQUARE = [0, 0, 0, 20, 0, 0, 20, 20, 3, 0, 20, 0];

test('a shape on a site far away has the picture that it has at the origin', () => {
  // Its vertices were rounded to half a metre.
  const site = [400_123.4, 5_500_017.3, 412.7];
  assert.deepEqual(drawn(SQUARE.map((value, i) => value + site[i % 3])), drawn(SQUARE));
});

test('a vertex of no face has no part in the picture', () => {
  assert.deepEqual(drawn([...SQUARE, 9e5, 0, 0]), drawn(SQUARE));
});
