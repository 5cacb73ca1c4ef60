/** The essentials, or every control: a choice that is remembered. */

import { forget, remember } from '../../ui/safe-storage.js';

/** `index.html` looks there before the first paint. */
const KEY = 'shape-up.advanced';
const { dataset } = document.documentElement;

/** @param {import("../../store/state.js").Store} store */
export function followAdvanced(store) {
  store.set({ advanced: dataset.advanced !== undefined });
  store.subscribe(['advanced'], ({ advanced }) => {
    if (advanced === (dataset.advanced !== undefined)) return;
    if (advanced) {
      dataset.advanced = '';
      remember(KEY, 'shown');
    } else {
      delete dataset.advanced;
      forget(KEY);
    }
  });
  // Its controls are there.
  store.subscribe(['flatMap'], ({ flatMap }) => flatMap && store.set({ advanced: true }));
}
