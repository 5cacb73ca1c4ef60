/**
 * The mesh of a scene in few bytes: its faces as they are, its positions rounded to a step, both as
 * differences to what those before say. The order of vertices and faces stays, and where faces begin.
 */

import { codeFaces } from './face-code.js';
import { codePositions } from './position-code.js';
import { RangeReader, RangeWriter } from './range-coder.js';

/** @typedef {[number, number, number]} Vector */
/** @typedef {{ positions: Vector[], faces: number[][] }} Mesh */
/** 1, 2 or 5 times a power of ten, so that rounded numbers are short. @typedef {{ factor: number, exponent: number }} Step */

/** A mesh with more vertices or faces has no short link. */
const MOST_COUNT = 200_000;
/** Steps from the first vertex to another, and from the origin to the first. */
const [FARTHEST, FARTHEST_ORIGIN] = [2 ** 29, 2 ** 45];
/** Keys of contexts that no other quantity has. */
const KEY = 1 << 20;
/** Larger numbers are written in parts of so many bits. */
const PART = 2 ** 24;
const EXPONENTS = 22;

/**
 * The step that is at most a length.
 * @param {number} length above 0
 * @returns {Step | null} null where no such power of ten is exact
 */
export function stepBelow(length) {
  const exponent = Math.floor(Math.log10(length));
  const factor = [5, 2, 1].find((one) => scaled(one, { factor: 1, exponent }) <= length);
  if (factor === undefined) return stepBelow(length * 0.99);
  return Math.abs(exponent) <= EXPONENTS ? { factor, exponent } : null;
}

/** So many steps as a length, the nearest number to it. @param {number} count @param {Step} step */
export function scaled(count, { factor, exponent }) {
  const size = 10 ** Math.abs(exponent);
  // A quotient of whole numbers is the number that its decimals say.
  return exponent < 0 ? (count * factor) / size : count * factor * size;
}

/**
 * Writes a mesh with its positions rounded to a step.
 * @param {Mesh} mesh
 * @param {Step} step
 * @returns {Uint8Array | null} null where rounding would join vertices that are apart, or does not fit
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
 * @param {boolean} inPlanes whether it was written with the planes of its faces
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
