/**
 * What is remembered in this browser, or in this tab. Where storage is blocked, as in some private
 * windows, or the page is embedded in another one, nothing is, and the page works without.
 */

import { isEmbedded } from './embedded.js';

/** @param {"localStorage" | "sessionStorage"} name throws where nothing may be remembered */
function storage(name) {
  if (isEmbedded) throw new Error('an embedded view stores nothing');
  return window[name];
}

/**
 * @param {string} key
 * @param {"localStorage" | "sessionStorage"} [where] the browser, or the tab
 * @returns {string | null}
 */
export function recall(key, where = 'localStorage') {
  try {
    return storage(where).getItem(key);
  } catch {
    return null;
  }
}

/**
 * @param {string} key
 * @param {string} value
 * @param {"localStorage" | "sessionStorage"} [where]
 */
export function remember(key, value, where = 'localStorage') {
  try {
    storage(where).setItem(key, value);
  } catch {
    // It holds for this visit.
  }
}

/** @param {string} key of what is remembered in this browser */
export function forget(key) {
  try {
    storage('localStorage').removeItem(key);
  } catch {
    // Nothing was remembered.
  }
}

/** The keys in this browser that begin so. @param {string} beginning */
export function keysOf(beginning) {
  try {
    return Object.keys(storage('localStorage')).filter((key) => key.startsWith(beginning));
  } catch {
    return [];
  }
}
