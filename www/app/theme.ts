/** Light or dark theme: follows the system until the user chooses one. */

import { setItem } from '../ui/safe-storage.ts';
import type { Store } from '../store/state.ts';

/** Storage key; every page reads it before its first paint. */
const KEY = 'shape-up.theme';
const system = matchMedia('(prefers-color-scheme: dark)');

export function followTheme(store: Store) {
  const show = () => store.set({ dark: isDark() });
  system.addEventListener('change', show);
  show();
}

export function toggleTheme(store: Store) {
  const theme = isDark() ? 'light' : 'dark';
  document.documentElement.dataset.theme = theme;
  setItem(KEY, theme);
  store.set({ dark: theme === 'dark' });
}

function isDark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === 'dark' : system.matches;
}
