/** Light and dark: the system's choice until somebody makes one here. */

const KEY = 'shape-up.theme';
const system = matchMedia('(prefers-color-scheme: dark)');

/** @param {import("./state.js").Store} store */
export function followTheme(store) {
  const show = () => store.set({ dark: isDark() });
  system.addEventListener('change', show);
  show();
}

/** @param {import("./state.js").Store} store */
export function toggleTheme(store) {
  const theme = isDark() ? 'light' : 'dark';
  document.documentElement.dataset.theme = theme;
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // Storage is blocked: it holds for this visit.
  }
  store.set({ dark: theme === 'dark' });
}

function isDark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === 'dark' : system.matches;
}
