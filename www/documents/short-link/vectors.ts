/** Vector operations with sums, products and quotients only, which every browser rounds alike. */

export type Vector = [number, number, number];

export const mean = (vectors: Vector[]): Vector => {
  const sum = (axis: number) =>
    vectors.reduce((total, vector) => total + vector[axis], 0) / vectors.length;
  return [sum(0), sum(1), sum(2)];
};

export const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export const dot = (a: ArrayLike<number>, b: ArrayLike<number>) =>
  a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
