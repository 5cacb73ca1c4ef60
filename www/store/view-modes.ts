/** Display modes besides the plain picture: the flat map beside the model, and a split view. */

import type {
  FewerFlips,
  MapNorm,
  MapWeights,
  Measure,
  Parametrization,
} from '../solver/messages.ts';

/**
 * Content of a surface: the checkerboard of the map, or the colours of the quasi-conformal error.
 */
type Look = 'checks' | 'errors';

export interface FlatMap {
  found: Parametrization;
  /** of the computation */
  weights: MapWeights;
  /** of the computation */
  norm: MapNorm;
  /** of the shape that was flattened */
  iteration: number;
  /** settings with fewer flipped triangles; null if not searched */
  fewerFlips: FewerFlips | 'searching' | 'none' | null;
  onModel: Look;
  onMap: Look;
  /** number of squares along the longer side of the map */
  squares: number;
}

/** Content of a side: the original, the current shape or a kept one, coloured by a measure. */
export type Choice = { measure: Measure; original: boolean; variant?: KeptShape };

/** A kept shape. */
export type KeptShape = { index: number; name: string; positions: Float64Array };

/** data of a side for the view */
export interface Shown {
  /** of the original, if that is shown */
  positions: Float64Array | undefined;
  /** of the faces */
  values: Float32Array | undefined;
  /** values of the vertices, for bands (maximum per face) */
  corners: Float32Array | undefined;
  /** beginning of the range of the colours */
  low: number;
  /** end of the range of the colours */
  top: number;
  /** beginning of the range, up to which faces keep their material */
  tolerance: number | null;
}

export interface Split {
  /** position of the divider, from 0 to 1 */
  at: number;
  /** left and right; new objects when they change */
  sides: [Choice & Shown, Choice & Shown];
}

export {};
