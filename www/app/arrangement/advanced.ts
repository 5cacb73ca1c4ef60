/** Shows the essential controls or all of them, and stores the choice. */

import { removeItem, setItem } from '../../ui/safe-storage.ts';
import type { Store } from '../../store/state.ts';

/** Storage key; `index.html` reads it before the first paint. */
const KEY = 'shape-up.advanced';
const { dataset } = document.documentElement;

export function followAdvanced(store: Store) {
  store.set({ advanced: dataset.advanced !== undefined });
  store.subscribe(['advanced'], ({ advanced }) => {
    if (advanced === (dataset.advanced !== undefined)) return;
    if (advanced) {
      dataset.advanced = '';
      setItem(KEY, 'shown');
    } else {
      delete dataset.advanced;
      removeItem(KEY);
    }
  });
  // The controls of the flat map are among the advanced ones.
  store.subscribe(['flatMap'], ({ flatMap }) => flatMap && store.set({ advanced: true }));
}
