/**
 * Storage in this browser or tab. If it is blocked, as in some private windows, or the page is
 * embedded in another one, nothing is stored, and the page works without.
 */

import { isEmbedded } from './embedded.ts';

/** @param name throws if nothing may be stored */
function storage(name: 'localStorage' | 'sessionStorage') {
  if (isEmbedded) throw new Error('an embedded view stores nothing');
  return window[name];
}

/** @param where the browser, or the tab */
export function getItem(
  key: string,
  where: 'localStorage' | 'sessionStorage' = 'localStorage',
): string | null {
  try {
    return storage(where).getItem(key);
  } catch {
    return null;
  }
}

export function setItem(
  key: string,
  value: string,
  where: 'localStorage' | 'sessionStorage' = 'localStorage',
) {
  try {
    storage(where).setItem(key, value);
  } catch {
    // The setting is kept for this visit only.
  }
}

/** @param key in this browser */
export function removeItem(key: string) {
  try {
    storage('localStorage').removeItem(key);
  } catch {
    // Nothing was stored.
  }
}

/** Returns the keys in this browser with a prefix. */
export function keysOf(beginning: string) {
  try {
    return Object.keys(storage('localStorage')).filter((key) => key.startsWith(beginning));
  } catch {
    return [];
  }
}
