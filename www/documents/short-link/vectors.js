/** Vector operations with sums, products and quotients only, which every browser rounds alike. */

/** @typedef {[number, number, number]} Vector */

/** @param {Vector[]} vectors @returns {Vector} */
export const mean = (vectors) => {
  const sum = (/** @type {number} */ axis) =>
    vectors.reduce((total, vector) => total + vector[axis], 0) / vectors.length;
  return [sum(0), sum(1), sum(2)];
};

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
