/**
 * Storage in this browser or tab. If it is blocked, as in some private windows, or the page is
 * embedded in another one, nothing is stored, and the page works without.
 */

import { isEmbedded } from './embedded.js';

/** @param {"localStorage" | "sessionStorage"} name throws if nothing may be stored */
function storage(name) {
  if (isEmbedded) throw new Error('an embedded view stores nothing');
  return window[name];
}

/**
 * @param {string} key
 * @param {"localStorage" | "sessionStorage"} [where] the browser, or the tab
 * @returns {string | null}
 */
export function getItem(key, where = 'localStorage') {
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
export function setItem(key, value, where = 'localStorage') {
  try {
    storage(where).setItem(key, value);
  } catch {
    // The setting is kept for this visit only.
  }
}

/** @param {string} key in this browser */
export function removeItem(key) {
  try {
    storage('localStorage').removeItem(key);
  } catch {
    // Nothing was stored.
  }
}

/** Returns the keys in this browser with a prefix. @param {string} beginning */
export function keysOf(beginning) {
  try {
    return Object.keys(storage('localStorage')).filter((key) => key.startsWith(beginning));
  } catch {
    return [];
  }
}
