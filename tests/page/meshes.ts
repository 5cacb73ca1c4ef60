// Meshes for the page tests, small enough to be solved in an instant.

/** The OBJ text of a grid of n by m unit quads with these heights. */
export function gridText(n: number, height: (x: number, y: number) => number, m = n) {
  const lines: string[] = [];
  for (let y = 0; y <= m; y++) {
    for (let x = 0; x <= n; x++) lines.push(`v ${x} ${y} ${height(x, y).toFixed(6)}`);
  }
  for (let y = 0; y < m; y++) {
    for (let x = 0; x < n; x++) {
      const corner = y * (n + 1) + x + 1;
      lines.push(`f ${corner} ${corner + 1} ${corner + n + 2} ${corner + n + 1}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** A wavy grid. */
export const wavyGrid = (n: number) =>
  gridText(n, (x, y) => 0.4 * Math.sin(1.3 * x + 0.4 * y) + 0.3 * Math.cos(0.9 * y));

/** A grid over bumps so steep that some circular panels fold. */
export const bumpyGrid = (n: number) =>
  gridText(n, (x, y) => 2 * Math.sin(0.5 * x) * Math.sin(0.5 * y));

/** A grid of steps that cannot be flat without folds. */
export const steppedGrid = (n: number) => gridText(n, (x, y) => 0.3 * ((x * y) % 5));

/** A barrel vault of n by n quads, whose edges are turned by so many degrees against its axis. */
export function barrel(n: number, degrees: number) {
  const [c, s] = [Math.cos, Math.sin].map((f) => f((degrees * Math.PI) / 180));
  const turned = (line: string) => {
    if (!line.startsWith('v ')) return line;
    const [i, j] = line
      .slice(2)
      .split(' ')
      .map((one) => Number(one) - n / 2);
    const [x, y] = [c * i - s * j, s * i + c * j];
    return `v ${x.toFixed(6)} ${y.toFixed(6)} ${(-0.1 * x * x).toFixed(6)}`;
  };
  return gridText(n, () => 0)
    .split('\n')
    .map(turned)
    .join('\n');
}

/** A roof of 40 by 24 panels that comes down to eight columns. */
export function columns() {
  const feet = [6, 15, 25, 34].flatMap((x) => [7, 17].map((y) => [x, y] as const));
  const depth = (x: number, y: number) =>
    Math.max(...feet.map(([a, b]) => 2.6 * Math.exp(-((x - a) ** 2 + (y - b) ** 2) / 5)));
  return gridText(40, (x, y) => 5 - depth(x, y), 24);
}

/**
 * The OBJ text of a tube of 12 by 4 quads, open at both ends.
 * @param shape.width of the tube across, as a part of its depth
 * @param shape.taper by how much it is wider at the upper end
 * @param shape.power of the heights of its rings: 2 moves them to the lower end
 */
export function tube({ width = 1, taper = 0, power = 1 } = {}) {
  const [around, along] = [12, 4];
  const lines = [];
  for (let v = 0; v < around * (along + 1); v++) {
    const angle = (2 * Math.PI * v) / around;
    const height = (Math.floor(v / around) / along) ** power;
    const radius = 1 + taper * height;
    const [x, y] = [radius * Math.cos(angle), width * radius * Math.sin(angle)];
    lines.push(`v ${x.toFixed(6)} ${y.toFixed(6)} ${3 * height}`);
  }
  for (let f = 0; f < around * along; f++) {
    const below = f + 1;
    const next = f % around === around - 1 ? below + 1 - around : below + 1;
    lines.push(`f ${below} ${next} ${next + around} ${below + around}`);
  }
  return `${lines.join('\n')}\n`;
}

/** Returns a number from -1 to 1 for a seed, the same on every machine. */
const noise = (seed: number) => ((seed * 7919 + 104729) % 2003) / 1001.5 - 1;

/** A scene whose mesh starts away from its rest shape, so that every kind has an effect. */
function disturbed(mesh: { positions: number[][]; faces?: number[][]; tets?: number[][] }) {
  const current = mesh.positions.map((point, v) =>
    point.map((x, axis) => x + 0.12 * noise(3 * v + axis + 1)),
  );
  return JSON.stringify({ format: 'shape-up-scene', version: 1, mesh, current });
}

/** The corners of a bumpy grid of n by n squares, and the corners of each square in order. */
function grid(n: number) {
  const positions: number[][] = [];
  const squares: number[][] = [];
  for (let y = 0; y <= n; y++)
    for (let x = 0; x <= n; x++) positions.push([x, y, 0.2 * ((3 * x + 5 * y) % 4)]);
  for (let y = 0; y < n; y++)
    for (let x = 0; x < n; x++) {
      const corner = y * (n + 1) + x;
      squares.push([corner, corner + 1, corner + n + 2, corner + n + 1]);
    }
  return { positions, squares };
}

/** The scene text of n by n quads. */
export function quadScene(n: number) {
  const { positions, squares } = grid(n);
  return disturbed({ positions, faces: squares });
}

/** The scene text of 40 by 40 quads whose run never converges. */
export function endlessScene() {
  const scene = JSON.parse(quadScene(40));
  scene.constraints = [{ kind: 'circle', on: 'faces' }];
  scene.solver = { tolerance: 0, accelerator: 'none' };
  return JSON.stringify(scene);
}

/** The scene text of n by n squares of two triangles each. */
export function triangleScene(n: number) {
  const { positions, squares } = grid(n);
  const faces = squares.flatMap(([a, b, c, d]) => [
    [a, b, c],
    [a, c, d],
  ]);
  return disturbed({ positions, faces });
}

/** The scene text of a cube of five tetrahedra. */
export function tetScene() {
  const corners = [0, 1].flatMap((z) => [0, 1].flatMap((y) => [0, 1].map((x) => [x, y, z])));
  const tets = [
    [0, 1, 2, 4],
    [3, 2, 1, 7],
    [5, 4, 7, 1],
    [6, 7, 4, 2],
    [1, 2, 4, 7],
  ];
  return disturbed({ positions: corners, tets });
}

/** The OBJ text of a closed, leaning box. */
export function box() {
  const places = [0, 3].flatMap((z) => [0, 2].flatMap((y) => [0, 1].map((x) => [x, y, z])));
  const corners = places.map(
    ([x, y, z]) => `v ${x + 0.4 * y * z} ${y + 0.3 * x * z} ${z + 0.5 * x * y}`,
  );
  const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'];
  return [...corners, ...faces.map((face) => `f ${face}`), ''].join('\n');
}

/** A file for a file input. */
export const file = (name: string, text: string) => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(text),
});

/** The OBJ text of a vault of triangles, n by n pairs of them, without corners to follow. */
export function vault(n: number) {
  const lines = ['# units: m'];
  const at = (i: number) => (12 * i) / n - 6;
  for (let j = 0; j <= n; j++)
    for (let i = 0; i <= n; i++)
      lines.push(`v ${at(i)} ${at(j)} ${4 - 0.08 * at(i) ** 2 - 0.02 * at(j) ** 2}`);
  for (let j = 0; j < n; j++)
    for (let i = 0; i < n; i++) {
      const [a, b] = [j * (n + 1) + i + 1, j * (n + 1) + i + 2];
      lines.push(`f ${a} ${b} ${b + n + 1}`, `f ${a} ${b + n + 1} ${a + n + 1}`);
    }
  return `${lines.join('\n')}\n`;
}
