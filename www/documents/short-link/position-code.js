/**
 * Positions in a link: a vertex is predicted by the faces around it, and its difference to that is coded. Where a
 * face says its plane, the coordinate that leaves the plane fastest comes last, and the others predict it.
 */

import { Predictor } from './predictor.js';

/** @typedef {import("./range-coder.js").RangeCoder} RangeCoder */

/** Contexts go by the length of the last differences, in steps of two bits. */
const LENGTHS = 7;
const KEY = 1 << 16;
/** That of differences to planes: they are as short as none. */
const PLANE_KEY = KEY + 3 * LENGTHS;
const [LEVEL_BEGIN, PLANE_LEVEL_BEGIN] = [6, 1];
/** Of the first difference, in bits. */
const FIRST = 12;

/** Nothing is predicted farther away, in steps. */
const FARTHEST = 2 ** 30;

/**
 * Writes positions, or reads them.
 * @param {RangeCoder} coder
 * @param {number[][]} faces
 * @param {Int32Array} places `#V by 3`, in steps; a reader fills it
 * @param {boolean} inPlanes whether faces say their planes: in the first links they did not
 */
export function codePositions(coder, faces, places, inPlanes) {
  const predictor = new Predictor(faces, places, inPlanes);
  /** The lengths of the last differences, in bits: of those in a plane, and of those to it. */
  let [length, planeLength] = [FIRST, FIRST];

  /** Codes a coordinate; returns the length of its difference. @type {(at: number, value: number, key: number) => number} */
  const coordinate = (at, value, key) => {
    const predicted = Math.abs(value) < FARTHEST ? Math.round(value) : 0;
    const difference = coder.integer(key, places[at] - predicted);
    places[at] = predicted + difference;
    return 32 - Math.clz32(Math.abs(difference));
  };

  const code = (/** @type {number} */ vertex) => {
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
    predictor.know(vertex);
  };
  for (const face of predictor.around.order())
    for (let next = predictor.next(faces[face]); next >= 0; next = predictor.next(faces[face]))
      code(next);
  for (let vertex = 0; vertex < places.length / 3; vertex++)
    if (!predictor.isKnown[vertex]) code(vertex);
}

/** @param {number} length in bits @param {number} begin that of the lowest level */
const levelOf = (length, begin) =>
  Math.min(Math.max(Math.round((length - begin) / 2), 0), LENGTHS - 1);
