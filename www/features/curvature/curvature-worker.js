/**
 * The worker of the curvature card: answers one question after another, with an instance of the
 * engine of its own.
 */

import init, { SurfaceCurvature } from '../../pkg/engine/shape_up.js';
import { messageOf } from '../../solver/messages.js';

/**
 * A question: the shape if it has changed, and the lines to draw on it.
 * @typedef {object} Question
 * @property {{ positions: Float64Array, offsets: Uint32Array, indices: Uint32Array }} [shape]
 * @property {"strokes" | "lines" | "through"} draw
 * @property {number | null} distance of lines, in the unit of the mesh; null for the default
 * @property {Uint32Array} vertices that lines pass through
 * @property {Uint32Array} faces whose centres lines pass through
 */

/** @typedef {{ points: Float64Array, offsets: Uint32Array, count: number, distance: number }} Answer */

const ready = init();
/** @type {SurfaceCurvature | null} */
let surface = null;

/** @param {Question} question @returns {Answer} */
function answer({ shape, draw, distance, vertices, faces }) {
  if (shape || !surface) {
    const { positions, offsets, indices } = /** @type {NonNullable<typeof shape>} */ (shape);
    surface?.free();
    // The constructor may throw.
    surface = null;
    surface = new SurfaceCurvature(positions, offsets, indices);
  }
  const apart = distance ?? surface.distance();
  const drawing =
    draw === 'strokes'
      ? surface.strokes()
      : draw === 'lines'
        ? surface.lines(apart)
        : surface.linesThrough(vertices, faces);
  const { points, offsets, count } = drawing;
  drawing.free();
  return { points, offsets, count, distance: apart };
}

/** @param {MessageEvent<Question>} message */
onmessage = async ({ data }) => {
  try {
    await ready;
    const value = answer(data);
    postMessage({ value }, [value.points.buffer, value.offsets.buffer]);
  } catch (error) {
    postMessage({ refused: messageOf(error) });
  }
};
