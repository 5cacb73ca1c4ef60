// Free-form roofs as a student brings them: irregular triangles that follow nothing.

import { existsSync, readFileSync } from 'node:fs';
import { at } from './project.mjs';
import { Problem } from './run.mjs';

/** Returns numbers from -1/2 to 1/2, the same in every run. */
function random() {
  let state = 7;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647 - 0.5;
  };
}

/** The triangles of the vault of the example, to which its panels are kept close: { points, faces }. */
export function vaultTriangles() {
  const scene = at('www', 'examples', 'other-new-panels.shapeup.json');
  if (!existsSync(scene)) throw new Problem(`npm run build writes ${scene}`);
  const { mesh } = JSON.parse(readFileSync(scene, 'utf8')).closeness.to;
  return { points: mesh.positions, faces: mesh.faces };
}

/** A roof with two hills of different height and a valley between them, over a plan with bent sides. */
function hills(u, v) {
  const [x, y] = [15 * (2 * u - 1) + 1.5 * v * v, 9 * v - 2 * (2 * u - 1) ** 2];
  const hill = (at, across, height, width) =>
    height * Math.exp(-((x - at) ** 2 + (y - across) ** 2) / (2 * width * width));
  return [x, y, hill(-7, 1, 6, 5.5) + hill(7.5, -2, 4.5, 6)];
}

/** The triangles of the roof with two hills. */
export const hillTriangles = () => trianglesOn(hills);

/** Returns { points, faces }: about twice `along` times `across` triangles on a surface. */
function trianglesOn(surface, along = 44, across = 26) {
  const next = random();
  // The vertices of the boundary stay on it.
  const shift = (k, most) => (k === 0 || k === most ? k : k + 0.6 * next()) / most;
  const points = [];
  for (let i = 0; i <= along; i++)
    for (let j = 0; j <= across; j++)
      points.push(surface(shift(i, along), 2 * shift(j, across) - 1));
  const faces = [];
  for (let i = 0; i < along; i++)
    for (let j = 0; j < across; j++) {
      const a = i * (across + 1) + j;
      const [b, c, d] = [a + across + 1, a + across + 2, a + 1];
      if (next() < 0) faces.push([a, b, c], [a, c, d]);
      else faces.push([a, b, d], [b, c, d]);
    }
  return { points, faces };
}
