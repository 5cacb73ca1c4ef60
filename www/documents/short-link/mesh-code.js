/**
 * Compact code of a mesh: faces exactly, positions rounded to a step, both predicted from those
 * already coded. The order of vertices and faces and the first corner of each face are kept.
 */

import { codeFaces } from './face-code.js';
import { codePositions } from './position-code.js';
import { RangeReader, RangeWriter } from './range-coder.js';

/** @typedef {[number, number, number]} Vector */
/** @typedef {{ positions: Vector[], faces: number[][] }} Mesh */
/**
 * Rounding step: 1, 2 or 5 times a power of ten, so that rounded numbers are short.
 * @typedef {{ factor: number, exponent: number }} Step
 */

/** Largest number of vertices or faces of a mesh in a short link. */
const MOST_COUNT = 200_000;
/** Largest distance in steps from the first vertex to another, and from the origin to the first. */
const [FARTHEST, FARTHEST_ORIGIN] = [2 ** 29, 2 ** 45];
/** Context keys used by no other quantity. */
const KEY = 1 << 20;
/** Larger numbers are coded in parts of 24 bits. */
const PART = 2 ** 24;
const EXPONENTS = 22;

/**
 * Returns the largest step that is at most a length.
 * @param {number} length above 0
 * @returns {Step | null} null if the power of ten is not exact
 */
export function stepBelow(length) {
  const exponent = Math.floor(Math.log10(length));
  const factor = [5, 2, 1].find((one) => scaled(one, { factor: 1, exponent }) <= length);
  if (factor === undefined) return stepBelow(length * 0.99);
  return Math.abs(exponent) <= EXPONENTS ? { factor, exponent } : null;
}

/** Returns the length of `count` steps. @param {number} count @param {Step} step */
export function scaled(count, { factor, exponent }) {
  const size = 10 ** Math.abs(exponent);
  // A quotient of exact integers is rounded once, to the double nearest to the decimal number.
  return exponent < 0 ? (count * factor) / size : count * factor * size;
}

/**
 * Writes a mesh with its positions rounded to a step.
 * @param {Mesh} mesh
 * @param {Step} step
 * @returns {Uint8Array | null} null if rounding would merge distinct vertices or exceed the range
 */
export function writeMesh({ positions, faces }, step) {
  if (positions.length > MOST_COUNT || faces.length > MOST_COUNT) return null;
  const length = scaled(1, step);
  const rounded = positions.map((at) => at.map((value) => Math.round(value / length)));
  const origin = rounded[0];
  if (origin.some((value) => Math.abs(value) > FARTHEST_ORIGIN)) return null;
  const places = rounded.map((at) => at.map((value, axis) => value - origin[axis]));
  if (places.some((at) => at.some((value) => Math.abs(value) > FARTHEST))) return null;
  const apart = (/** @type {number[][]} */ points) => new Set(points.map(String)).size;
  if (apart(places) < apart(positions)) return null;
  const coder = new RangeWriter();
  codeHead(coder, { step, origin, vertices: positions.length, faces: faces.length });
  codePositions(
    coder,
    codeFaces(coder, positions.length, faces.length, faces),
    Int32Array.from(places.flat()),
    true,
  );
  return coder.bytes();
}

/**
 * @param {Uint8Array} bytes
 * @param {boolean} inPlanes whether it was written with plane prediction
 * @returns {Mesh}
 */
export function readMesh(bytes, inPlanes) {
  const coder = new RangeReader(bytes);
  const empty = { step: { factor: 1, exponent: 0 }, origin: [0, 0, 0], vertices: 0, faces: 0 };
  const { step, origin, vertices, faces: count } = codeHead(coder, empty);
  if (!(vertices >= 1 && vertices <= MOST_COUNT && count >= 0 && count <= MOST_COUNT))
    throw new RangeError('not a mesh');
  const faces = codeFaces(coder, vertices, count, []);
  const places = new Int32Array(3 * vertices);
  codePositions(coder, faces, places, inPlanes);
  const along = (/** @type {number} */ vertex, /** @type {number} */ axis) =>
    scaled(origin[axis] + places[3 * vertex + axis], step);
  const positions = Array.from({ length: vertices }, (_, vertex) => {
    /** @type {Vector} */
    const position = [along(vertex, 0), along(vertex, 1), along(vertex, 2)];
    return position;
  });
  return { positions, faces };
}

/**
 * @param {import("./range-coder.js").RangeCoder} coder
 * @param {{ step: Step, origin: number[], vertices: number, faces: number }} head
 */
function codeHead(coder, { step, origin, vertices, faces }) {
  const whole = (/** @type {number} */ value) => {
    const high = Math.floor(value / PART);
    return PART * coder.integer(KEY + 1, high) + coder.integer(KEY, value - PART * high);
  };
  return {
    step: { factor: whole(step.factor), exponent: whole(step.exponent) },
    origin: origin.map(whole),
    vertices: whole(vertices),
    faces: whole(faces),
  };
}
