/** Whether the flat map that is shown is of the shape as it is now. */

import { useComputed } from '@preact/signals';
import { useApp } from './use-app.ts';
import type { AppContext } from '../app/context.ts';
import type { FlatMap, State } from './state.ts';

/** Whether a map is that of a shape with these positions. */
const isMapOf = ({ shape }: FlatMap, positions: Float64Array | undefined) =>
  positions?.length === shape.length && positions.every((x, i) => x === shape[i]);

/** Whether a map is shown and the shape has changed since. Each shape comes with its numbers. */
const isStale = ({ solver }: Pick<AppContext, 'solver'>, { numbers, flatMap }: Readonly<State>) =>
  Boolean(flatMap && numbers && !isMapOf(flatMap, solver.geometry?.positions));

/** As a hook, for a component that is rendered only when that changes. */
export function useStaleMap() {
  const app = useApp();
  return useComputed(() => isStale(app, app.store.state)).value;
}

/** What a file of the shape has of the map, in words; empty if none is shown. */
export const mapInWords = (app: Pick<AppContext, 'solver'>, state: Readonly<State>) =>
  state.flatMap &&
  `with ${isStale(app, state) ? 'the flat map of an earlier shape' : 'its flat map'}`;
