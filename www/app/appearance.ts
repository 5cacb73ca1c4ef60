/**
 * Attributes of the page for the style sheets: the theme, the next step (`store/next-step.ts`),
 * whose button is filled, and whether the model moves, which hides the overlays in small windows.
 */

import './next-step.css';
import { NEXT_STEP_KEYS, nextStep } from '../store/next-step.ts';
import { setItem } from '../ui/safe-storage.ts';
import type { Store } from '../store/state.ts';

/** Storage key of the theme; every page reads it before its first paint. */
const THEME = 'shape-up.theme';
const { dataset } = document.documentElement;
const system = matchMedia('(prefers-color-scheme: dark)');

/** Light or dark: follows the system until the user chooses one. */
export function followTheme(store: Store) {
  const show = () => store.set({ dark: isDark() });
  system.addEventListener('change', show);
  show();
}

/** Chooses the other theme. */
export function toggleTheme(store: Store) {
  const theme = isDark() ? 'light' : 'dark';
  dataset.theme = theme;
  setItem(THEME, theme);
  store.set({ dark: theme === 'dark' });
}

function isDark() {
  const { theme } = dataset;
  return theme ? theme === 'dark' : system.matches;
}

/** `data-next` and `data-moves` of the body. */
export function followNextStep(store: Store) {
  const { dataset } = document.body;
  store.subscribe([...NEXT_STEP_KEYS, 'dragged'], (state) => {
    const moves = String(state.running || state.dragged.length > 0);
    if (dataset.moves !== moves) dataset.moves = moves;
    const next = nextStep(state);
    if (dataset.next !== next) dataset.next = next;
  });
}
