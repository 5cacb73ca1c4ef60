/** Lines of curvature on a shape, computed in the second worker. */

import { SurfaceCurvature } from '../../pkg/engine/shape_up.js';

/** A shape if it is another one than that of the last question, and the lines to draw on it. */
export interface Question {
  shape?: { positions: Float64Array; offsets: Uint32Array; indices: Uint32Array };
  draw: 'strokes' | 'lines';
  /** of lines, in the unit of the mesh; null for the default */
  distance: number | null;
}

export type Lines = {
  points: Float64Array;
  offsets: Uint32Array;
  count: number;
  distance: number;
};

let surface: SurfaceCurvature | null = null;

export const curvature = {
  /** @returns null if the shape is needed and not given */
  surfaceLines({ shape, draw, distance }: Question): Lines | null {
    if (shape) {
      const { positions, offsets, indices } = shape;
      surface?.free();
      // The constructor may throw.
      surface = null;
      surface = new SurfaceCurvature(positions, offsets, indices);
    }
    if (!surface) return null;
    const apart = distance ?? surface.distance();
    const drawing = draw === 'strokes' ? surface.strokes() : surface.lines(apart);
    const { points, offsets, count } = drawing;
    drawing.free();
    return { points, offsets, count, distance: apart };
  },
};
