/** The energies of the iterations, as the plot has them. */

import { energyOrZero } from '../words.ts';

/** Numbers per iteration in a trace. */
export const TRACE_WIDTH = 6;
/** Decades below the greatest energy that are on the scale. */
export const DECADES = 12;
/** The energies in the order of their columns, with the width of the line of each. */
export const SERIES = [
  { id: 'shape', label: 'Shape', width: 1.25 },
  { id: 'close', label: 'Close', width: 1.25 },
  { id: 'smooth', label: 'Smooth', width: 1.25 },
  { id: 'handles', label: 'Handles', width: 1.25 },
  { id: 'total', label: 'Total', width: 2 },
];

/** Returns the columns of a trace: the iteration, then one of each energy; rounding errors as zero. */
export function columnsOf(trace: Float64Array, size: number) {
  const rows = trace.length / TRACE_WIDTH;
  return Array.from({ length: TRACE_WIDTH }, (_, column) =>
    Array.from({ length: rows }, (_, row) => {
      const value = trace[row * TRACE_WIDTH + column];
      return column === 0 ? value : energyOrZero(value, size);
    }),
  );
}
