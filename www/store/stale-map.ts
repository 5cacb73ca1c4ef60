/** Whether the flat map that is shown is of the shape as it is now. */

import { useComputed } from '@preact/signals';
import { useApp } from './use-app.ts';
import type { FlatMap } from './state.ts';

/** Whether a map is that of a shape with these positions. */
export const isMapOf = ({ shape }: FlatMap, positions: Float64Array | undefined) =>
  positions?.length === shape.length && positions.every((x, i) => x === shape[i]);

/** Whether a map is shown and the shape has changed since. */
export function useStaleMap() {
  const { store, solver } = useApp();
  const { state } = store;
  // Each shape comes with its numbers.
  return useComputed(() => {
    const { numbers, flatMap } = state;
    return Boolean(numbers && flatMap && !isMapOf(flatMap, solver.geometry?.positions));
  }).value;
}
