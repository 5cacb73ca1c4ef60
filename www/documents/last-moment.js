/**
 * Fallback for saves when the page closes: a browser may drop a pending database write at that
 * moment. The data is written to local storage at once, and to the database on the next visit.
 */

import { getItem, keysOf, removeItem, setItem } from '../ui/safe-storage.js';
import { keep, recentDocuments } from './recent-documents.js';

/** @typedef {import("./recent-documents.js").Work} Work */
/** @typedef {import("./recent-documents.js").Contents} Contents */

/** Prefix of the key; the id of the work follows, so that tabs do not overwrite each other. */
const KEY = 'shape-up.last-moment ';
/** Longest undo history or progress stored: browsers allow about five million characters, scene included. */
const MOST_BYTES = 1_000_000;

/** @param {Work} work @param {Partial<Contents>} contents what the database lacks */
export function storeUnsaved(work, contents) {
  // Null deletes what the database has, which is right only if it belongs to an earlier scene.
  const tooLong = 'text' in contents ? null : undefined;
  const write = (/** @type {string} */ _, /** @type {unknown} */ value) => {
    if (!(value instanceof Uint8Array)) return value;
    return value.length > MOST_BYTES ? tooLong : lettersOf(value);
  };
  setItem(KEY + work.id, JSON.stringify({ work, contents }, write));
}

/** Deletes the fallback copy once the database has all of the work. @param {string} id */
export function forgetUnsaved(id) {
  removeItem(KEY + id);
}

/** Moves the fallback copies into the database, unless its record is newer. */
export async function recoverUnsaved() {
  for (const key of keysOf(KEY)) {
    const { work, contents } = JSON.parse(getItem(key) ?? '{}');
    if (!work) continue;
    for (const part of ['history', 'progress'])
      if (contents[part]) contents[part] = bytesOf(contents[part]);
    const known = (await recentDocuments()).find(({ id }) => id === work.id);
    if (!known || known.savedAt < work.savedAt) await keep(work, contents);
    removeItem(key);
  }
}

/** @param {Uint8Array} bytes */
function lettersOf(bytes) {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

/** @param {string} letters */
function bytesOf(letters) {
  return Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
}
