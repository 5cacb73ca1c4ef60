/** Light or dark theme: follows the system until the user chooses one. */

import { setItem } from '../ui/safe-storage.js';

/** Storage key; every page reads it before its first paint. */
const KEY = 'shape-up.theme';
const system = matchMedia('(prefers-color-scheme: dark)');

/** @param {import("../store/state.js").Store} store */
export function followTheme(store) {
  const show = () => store.set({ dark: isDark() });
  system.addEventListener('change', show);
  show();
}

/** @param {import("../store/state.js").Store} store */
export function toggleTheme(store) {
  const theme = isDark() ? 'light' : 'dark';
  document.documentElement.dataset.theme = theme;
  setItem(KEY, theme);
  store.set({ dark: theme === 'dark' });
}

function isDark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === 'dark' : system.matches;
}
