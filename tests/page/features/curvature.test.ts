// A shape refused by the second worker is discarded on both sides.

import assert from 'node:assert/strict';
import { register } from 'node:module';
import { test } from 'node:test';
import type { AppContext } from '../../../www/app/context.ts';
import {
  CurvatureLines,
  type LinesRequest,
} from '../../../www/features/curvature/curvature-lines.ts';
import type { Lines, Question } from '../../../www/worker/jobs/curvature.ts';

test('after a refusal the shape is sent again', async () => {
  const sent: Question[] = [];
  const found = { points: new Float64Array(0), offsets: Uint32Array.of(0), count: 0, distance: 1 };
  let answer = (): Lines => {
    throw new Error('The surface has no area.');
  };
  const surfaceLinesOf = async (question: Question) => {
    sent.push({ ...question });
    return answer();
  };
  const connectivity = { faceOffsets: Uint32Array.of(0, 3), faceIndices: Uint32Array.of(0, 1, 2) };
  const app = {
    store: { get: () => ({ model, running: false }) },
    solver: { geometry: { generation: 1, positions: new Float64Array(9), connectivity } },
    jobs: { ask: { surfaceLines: surfaceLinesOf } },
    viewport: { unmeasured() {}, on() {} },
  } as unknown as AppContext;
  const model = { vertices: 3 };
  const how = { distance: null };
  const lines = new CurvatureLines(app);
  await lines.draw({ ...how, draw: 'strokes' });
  assert.equal(lines.result.value.refused, 'The surface has no area.');
  // The same request is not sent again; a different one is, together with the shape.
  await lines.draw({ ...how, draw: 'strokes' });
  answer = () => found;
  await lines.draw({ ...how, draw: 'lines' });
  await lines.draw({ ...how, draw: 'strokes' });
  assert.deepEqual(
    sent.map(({ draw, shape }) => [draw, Boolean(shape)]),
    [
      ['strokes', true],
      ['lines', true],
      ['strokes', false],
    ],
  );
});

test('another shape is sent to the worker, even one with equal sums of its coordinates', async () => {
  /** The shapes that were sent, by their first coordinate. */
  const sent: number[] = [];
  const surfaceLinesOf = async ({ shape }: Question) => {
    if (shape) sent.push(shape.positions[0]);
    return { points: new Float64Array(0), offsets: Uint32Array.of(0), count: 0, distance: 1 };
  };
  const connectivity = { faceOffsets: Uint32Array.of(0, 3), faceIndices: Uint32Array.of(0, 1, 2) };
  const shape = (generation: number, ...positions: number[]) => ({
    ...{ generation, connectivity, positions: Float64Array.from(positions) },
  });
  const solver = { geometry: shape(1, 1, 0, 0, 0, 1, 0, 0, 5, 0) };
  const model = { vertices: 3 };
  const app = {
    ...{ store: { get: () => ({ model, running: false }) }, solver },
    jobs: { ask: { surfaceLines: surfaceLinesOf } },
    viewport: { unmeasured() {}, on() {} },
  } as unknown as AppContext;
  const lines = new CurvatureLines(app);
  const strokes: LinesRequest = { draw: 'strokes', distance: null };
  await lines.draw(strokes);
  // The first and the eighth coordinate had the same weight in a check sum.
  solver.geometry = shape(2, 5, 0, 0, 0, 1, 0, 0, 1, 0);
  for (let turn = 0; turn < 2; turn++) await lines.draw(strokes);
  assert.deepEqual(sent, [1, 5]);
});

test('the worker does not use a surface that it has freed', async () => {
  const stand = `
    export default async () => {};
    export class SurfaceCurvature {
      #isFreed = false;
      constructor(positions) { if (positions.length === 0) throw new Error('no vertices'); }
      #live() { if (this.#isFreed) throw new Error('null pointer passed to rust'); }
      free() { this.#live(); this.#isFreed = true; }
      distance() { this.#live(); return 1; }
      strokes() { this.#live(); return { points: new Float64Array(3), offsets: Uint32Array.of(0, 1), count: 1, free() {} }; }
    }`;
  const hooks = `
    const url = 'data:text/javascript,' + ${JSON.stringify(encodeURIComponent(stand))};
    export const resolve = (name, context, next) =>
      name.endsWith('pkg/engine/shape_up.js') ? { url, shortCircuit: true } : next(name, context);`;
  register(`data:text/javascript,${encodeURIComponent(hooks)}`);
  const { curvature } = await import('../../../www/worker/jobs/curvature.ts');
  const ask = (length: number) => {
    const shape = {
      positions: new Float64Array(length),
      offsets: new Uint32Array(1),
      indices: new Uint32Array(0),
    };
    return curvature.surfaceLines({ shape, draw: 'strokes', distance: null });
  };
  assert.equal(ask(9)?.count, 1);
  assert.throws(() => ask(0), /no vertices/);
  assert.equal(ask(9)?.count, 1);
});
