/** Values read from the view after it was updated. */

import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import type { State } from '../../store/state.ts';

/** What changes the colours. */
const KEYS: (keyof State)[] = [
  ...(['measure', 'measures', 'range', 'spread', 'tolerances', 'document'] as const),
  ...(['renderer', 'model', 'dark', 'flatMap', 'display'] as const),
];

/**
 * Reads something of the view after it has been told the state: the subscriptions of the view are
 * older, while a component may be rendered before them.
 */
export function useAfterViewUpdate<Value>(read: (state: Readonly<State>) => Value): Value {
  const { store } = useApp();
  const [value, setValue] = useState(() => read(store.get()));
  useEffect(() => store.subscribe(KEYS, (state) => setValue(() => read(state))), []);
  return value;
}
