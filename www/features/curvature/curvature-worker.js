/**
 * The worker of the card: finds how a shape bends, one question after another. What does it is in the module of
 * parts.
 */

import init, { SurfaceCurvature } from '../../pkg/build/shape_up.js';
import { messageOf } from '../../solver/messages.js';

/**
 * A question: the shape where it is another one than before, and what to draw over it.
 * @typedef {object} Question
 * @property {{ positions: Float64Array, offsets: Uint32Array, indices: Uint32Array }} [shape]
 * @property {"strokes" | "lines" | "through"} draw
 * @property {number | null} distance of lines, in the unit of the mesh; null for one that suits
 * @property {Uint32Array} vertices that lines go through
 * @property {Uint32Array} faces that lines go through the middle of
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
