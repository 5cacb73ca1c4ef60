/** The range of the colours and the distribution of the values, which the view computes. */

import { toleranceOf } from './measures.ts';
import type { FaceMeasure } from '../../pkg/engine/shape_up.js';
import type { Measure } from '../../solver/types.ts';
import type { View } from '../../pkg/view-webgl2/shape_up.js';

type State = Readonly<import('../state.ts').State>;

/** The axis of a legend. */
export interface Axis {
  /** the value at its start; above 0 on a logarithmic axis */
  low: number;
  /** the value at its end */
  high: number;
  log: boolean;
}

export interface Spread {
  measure: Measure;
  /** absolute value */
  greatest: number;
  /** of the bars */
  axis: Axis;
  /** positions on the axis, from 0 to 1: of the ends of the range, and of the tolerance if there is one */
  places: { low: number; high: number; tolerance: number | null };
  /** faces per bar, `#bars` */
  counts: number[];
  /** number of faces with a value */
  faces: number;
  /** number of faces within the tolerance; all without one */
  within: number;
  /** the same bars for the original shape, without faces beyond the end */
  original: { counts: number[]; greatest: number } | null;
}

/**
 * Returns the range of the colours and the distribution of the values.
 * @param values `#F`, of the measure
 * @param original those of the original shape, if known
 */
export function spreadOf(
  view: View,
  state: State,
  about: FaceMeasure,
  values: Float32Array,
  original: Float32Array | null,
): { range: [number, number]; spread: Spread } {
  const { ownRange, display, model } = state;
  const tolerance = toleranceOf(state, about);
  const { id, signed } = about;
  const coloured = signed ? 'signed' : display.full ? 'all' : 'beyond';
  const ends = [ownRange.low, ownRange.high, ownRange.top].map((end) => end ?? NaN);
  const found = view.legendNumbers(
    ...([values, original, coloured, display.log, tolerance] as const),
    Float64Array.of(model?.roundings[id] ?? 0, ...ends),
  );
  const { range, axis, places, counts, greatest, faces, within } = found;
  const { originalCounts, originalGreatest } = found;
  found.free();
  return {
    range: [range[0], range[1]],
    spread: {
      ...{ measure: id, greatest, faces, within },
      axis: { low: axis[0], high: axis[1], log: display.log && !signed },
      places: { low: places[0], high: places[1], tolerance: places[2] ?? null },
      counts: [...counts],
      original: originalCounts
        ? { counts: [...originalCounts], greatest: originalGreatest ?? 0 }
        : null,
    },
  };
}
