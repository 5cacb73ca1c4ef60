/**
 * The worker of the curvature card: answers one question after another, with an instance of the
 * engine of its own.
 */

import init, { SurfaceCurvature } from '../../pkg/engine/shape_up.js';
import { messageOf } from '../../solver/errors.ts';

/** A question: the shape if it has changed, and the lines to draw on it. */
export interface Question {
  shape?: { positions: Float64Array; offsets: Uint32Array; indices: Uint32Array };
  draw: 'strokes' | 'lines' | 'through';
  /** of lines, in the unit of the mesh; null for the default */
  distance: number | null;
  /** that lines pass through */
  vertices: Uint32Array;
  /** whose centres lines pass through */
  faces: Uint32Array;
}

export type Answer = {
  points: Float64Array;
  offsets: Uint32Array;
  count: number;
  distance: number;
};

const ready = init();
let surface: SurfaceCurvature | null = null;

function answer({ shape, draw, distance, vertices, faces }: Question): Answer {
  if (shape || !surface) {
    const { positions, offsets, indices } = shape as NonNullable<typeof shape>;
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

onmessage = async ({ data }: MessageEvent<Question>) => {
  try {
    await ready;
    const value = answer(data);
    postMessage({ value }, [value.points.buffer, value.offsets.buffer]);
  } catch (error) {
    postMessage({ refused: messageOf(error) });
  }
};
