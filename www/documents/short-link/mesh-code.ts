/**
 * Compact code of a mesh: faces exactly, positions rounded to a step, both predicted from those
 * already coded. The order of vertices and faces and the first corner of each face are kept.
 */

import { codeFaces } from './face-code.ts';
import { codePositions } from './position-code.ts';
import { RangeReader, RangeWriter, type RangeCoder } from './range-coder.ts';

type Vector = [number, number, number];
type Mesh = { positions: Vector[]; faces: number[][] };
/** Rounding step: 1, 2 or 5 times a power of ten, so that rounded numbers are short. */
export type Step = { factor: number; exponent: number };

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
 * @param length above 0
 * @returns null if the power of ten is not exact
 */
export function stepBelow(length: number): Step | null {
  const exponent = Math.floor(Math.log10(length));
  const factor = [5, 2, 1].find((one) => scaled(one, { factor: 1, exponent }) <= length);
  if (factor === undefined) return stepBelow(length * 0.99);
  return Math.abs(exponent) <= EXPONENTS ? { factor, exponent } : null;
}

/** Returns the length of `count` steps. */
export function scaled(count: number, { factor, exponent }: Step) {
  const size = 10 ** Math.abs(exponent);
  // A quotient of exact integers is rounded once, to the double nearest to the decimal number.
  return exponent < 0 ? (count * factor) / size : count * factor * size;
}

/**
 * Writes a mesh with its positions rounded to a step.
 * @returns null if rounding would merge distinct vertices or exceed the range
 */
export function writeMesh({ positions, faces }: Mesh, step: Step): Uint8Array | null {
  if (positions.length > MOST_COUNT || faces.length > MOST_COUNT) return null;
  const length = scaled(1, step);
  const rounded = positions.map((at) => at.map((value) => Math.round(value / length)));
  const origin = rounded[0];
  if (origin.some((value) => Math.abs(value) > FARTHEST_ORIGIN)) return null;
  const places = rounded.map((at) => at.map((value, axis) => value - origin[axis]));
  if (places.some((at) => at.some((value) => Math.abs(value) > FARTHEST))) return null;
  const apart = (points: number[][]) => new Set(points.map(String)).size;
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

/** @param inPlanes whether it was written with plane prediction */
export function readMesh(bytes: Uint8Array, inPlanes: boolean): Mesh {
  const coder = new RangeReader(bytes);
  const empty = { step: { factor: 1, exponent: 0 }, origin: [0, 0, 0], vertices: 0, faces: 0 };
  const { step, origin, vertices, faces: count } = codeHead(coder, empty);
  if (!(vertices >= 1 && vertices <= MOST_COUNT && count >= 0 && count <= MOST_COUNT))
    throw new RangeError('not a mesh');
  const faces = codeFaces(coder, vertices, count, []);
  const places = new Int32Array(3 * vertices);
  codePositions(coder, faces, places, inPlanes);
  const along = (vertex: number, axis: number) =>
    scaled(origin[axis] + places[3 * vertex + axis], step);
  const positions = Array.from({ length: vertices }, (_, vertex) => {
    const position: Vector = [along(vertex, 0), along(vertex, 1), along(vertex, 2)];
    return position;
  });
  return { positions, faces };
}

function codeHead(
  coder: RangeCoder,
  {
    step,
    origin,
    vertices,
    faces,
  }: { step: Step; origin: number[]; vertices: number; faces: number },
) {
  const whole = (value: number) => {
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
