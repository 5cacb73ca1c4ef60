/** Lines of curvature on a shape, computed in the second worker. */

import { SurfaceCurvature } from '../../pkg/engine/shape_up.js';

/** A shape if it is another one than that of the last question, and the lines to draw on it. */
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

export type Lines = {
  points: Float64Array;
  offsets: Uint32Array;
  count: number;
  distance: number;
};

let surface: SurfaceCurvature | null = null;

export const curvature = {
  /** @returns null if the shape is needed and not given */
  surfaceLines({ shape, draw, distance, vertices, faces }: Question): Lines | null {
    if (shape) {
      const { positions, offsets, indices } = shape;
      surface?.free();
      // The constructor may throw.
      surface = null;
      surface = new SurfaceCurvature(positions, offsets, indices);
    }
    if (!surface) return null;
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
  },
};
