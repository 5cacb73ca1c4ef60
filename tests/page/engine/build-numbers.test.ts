// For which shape numbers of a build are stored.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import init, { Solver } from '../../../www/pkg/engine/shape_up.js';

test('numbers of the build of another shape are not stored, as those that come during a run', async () => {
  await init({
    module_or_path: new URL('../../../www/pkg/engine/shape_up_bg.wasm', import.meta.url),
  });
  const positions = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0.2],
    [0, 1, 0],
  ];
  const scene = {
    ...{
      format: 'shape-up-scene',
      version: 1,
      units: 'm',
      mesh: { positions, faces: [[0, 1, 2, 3]] },
    },
    lesson: { text: 'On few sheets.', goals: [{ build: 'sheets', at_most: 5 }] },
  };
  const solver = new Solver();
  solver.load('a.shapeup.json', new TextEncoder().encode(JSON.stringify(scene)));
  const told = () => JSON.parse(solver.results('Ada', '')).goals[0].value;
  const built = Float64Array.from(positions.flat());
  solver.setBuildNumbers(
    built.map((x) => x + 1),
    ['sheets'],
    Float64Array.of(3),
  );
  assert.equal(told(), null);
  solver.setBuildNumbers(built, ['sheets'], Float64Array.of(3));
  assert.equal(told(), 3);
});
