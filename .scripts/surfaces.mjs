// Free-form roofs as a student brings them: irregular triangles that follow nothing.

/** Returns numbers from -1/2 to 1/2, the same in every run. */
function random() {
  let state = 7;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647 - 0.5;
  };
}

/** A vault over a bent axis, wide at its ends: the point at u from 0 to 1 along it, v from -1 to 1 across. */
export function vault(u, v) {
  const [turn, flare] = [0.9 * (u - 0.5), (2 * u - 1) ** 2];
  const [half, rise] = [5.2 + 2.6 * flare, 4.2 + 1.6 * flare - 0.8 * u];
  const [side, height] = [half * Math.sin(1.5 * v), rise * Math.cos(1.5 * v)];
  const radius = 30 / 0.9;
  return [(radius - side) * Math.sin(turn), radius - (radius - side) * Math.cos(turn), height];
}

/** A roof with two hills of different height and a valley between them, over a plan with bent sides. */
export function hills(u, v) {
  const [x, y] = [15 * (2 * u - 1) + 1.5 * v * v, 9 * v - 2 * (2 * u - 1) ** 2];
  const hill = (at, across, height, width) =>
    height * Math.exp(-((x - at) ** 2 + (y - across) ** 2) / (2 * width * width));
  return [x, y, hill(-7, 1, 6, 5.5) + hill(7.5, -2, 4.5, 6)];
}

/** Returns { points, faces }: about twice `along` times `across` triangles on a surface. */
export function trianglesOn(surface, along = 44, across = 26) {
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
