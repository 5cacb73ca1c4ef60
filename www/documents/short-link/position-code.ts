/**
 * Coding of positions in a link: the difference of a vertex to its prediction from the faces around
 * it. If a face determines a plane, the coordinate along the axis closest to its normal is coded
 * last, predicted from the other two.
 */

import { Predictor } from './predictor.ts';
import type { RangeCoder } from './range-coder.ts';

/** Number of contexts by the bit length of the last differences, in steps of two bits. */
const LENGTHS = 7;
const KEY = 1 << 16;
/** Context key of differences to planes, which are much shorter. */
const PLANE_KEY = KEY + 3 * LENGTHS;
const [LEVEL_BEGIN, PLANE_LEVEL_BEGIN] = [6, 1];
/** Assumed length of the first difference, in bits. */
const FIRST = 12;

/** Bound on predicted coordinates, in steps. */
const FARTHEST = 2 ** 30;

/**
 * Writes or reads positions.
 * @param positions `#V by 3`, in steps; a reader fills it
 * @param inPlanes whether to predict by planes; the first links did not
 */
export function codePositions(
  coder: RangeCoder,
  faces: number[][],
  positions: Int32Array,
  inPlanes: boolean,
) {
  const predictor = new Predictor(faces, positions, inPlanes);
  /** Running lengths in bits of the differences: within planes, and to planes. */
  let [length, planeLength] = [FIRST, FIRST];

  /** Codes a coordinate; returns the bit length of its difference. */
  const coordinate: (at: number, value: number, key: number) => number = (at, value, key) => {
    const predicted = Math.abs(value) < FARTHEST ? Math.round(value) : 0;
    const difference = coder.integer(key, positions[at] - predicted);
    positions[at] = predicted + difference;
    return 32 - Math.clz32(Math.abs(difference));
  };

  const code = (vertex: number) => {
    const { kind, at, plane, learn } = predictor.of(vertex);
    const key = KEY + kind * LENGTHS + levelOf(length, LEVEL_BEGIN);
    const axes = [0, 1, 2].filter((axis) => axis !== plane?.axis);
    let bits = 0;
    for (const axis of axes) bits += coordinate(3 * vertex + axis, at[axis], key);
    length = (length + bits / axes.length) / 2;
    if (plane) {
      const planeKey = PLANE_KEY + levelOf(planeLength, PLANE_LEVEL_BEGIN);
      const bitsOff = coordinate(3 * vertex + plane.axis, plane.predicted(), planeKey);
      planeLength = (planeLength + bitsOff) / 2;
    }
    learn();
    predictor.add(vertex);
  };
  for (const face of predictor.around.order())
    for (let next = predictor.next(faces[face]); next >= 0; next = predictor.next(faces[face]))
      code(next);
  for (let vertex = 0; vertex < positions.length / 3; vertex++)
    if (!predictor.isKnown[vertex]) code(vertex);
}

/**
 * @param length in bits
 * @param begin length of the lowest level
 */
const levelOf = (length: number, begin: number) =>
  Math.min(Math.max(Math.round((length - begin) / 2), 0), LENGTHS - 1);
