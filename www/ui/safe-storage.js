/**
 * What is remembered in this browser, or in this tab. Where storage is blocked, as in some private
 * windows, nothing is, and the page works without.
 */

/**
 * @param {string} key
 * @param {"localStorage" | "sessionStorage"} [storage] of the browser, or of the tab
 * @returns {string | null}
 */
export function recall(key, storage = 'localStorage') {
  try {
    return window[storage].getItem(key);
  } catch {
    return null;
  }
}

/**
 * @param {string} key
 * @param {string} value
 * @param {"localStorage" | "sessionStorage"} [storage]
 */
export function remember(key, value, storage = 'localStorage') {
  try {
    window[storage].setItem(key, value);
  } catch {
    // It holds for this visit.
  }
}

/** @param {string} key of what is remembered in this browser */
export function forget(key) {
  try {
    window.localStorage.removeItem(key);
  } catch {
    // Nothing was remembered.
  }
}

/** The keys in this browser that begin so. @param {string} beginning */
export function keysOf(beginning) {
  try {
    return Object.keys(window.localStorage).filter((key) => key.startsWith(beginning));
  } catch {
    return [];
  }
}
