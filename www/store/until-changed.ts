/** Messages about a shape. */

import type { Store } from './state.ts';

/** Withdraws at the next edit or run a message that says and offers something about this shape. */
export function untilChanged(store: Store, withdraw: () => void) {
  const { document } = store.get();
  let { running } = store.get();
  const end = store.subscribe(['document', 'running'], (state) => {
    const begins = state.running && !running;
    ({ running } = state);
    if (!begins && state.document === document) return;
    withdraw();
    end();
  });
}
