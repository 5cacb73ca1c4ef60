/**
 * What a page that goes cannot wait for: a browser may drop what is on its way to the database when the
 * page closes. It is put where writing takes effect at once, and goes to the database when a page opens
 * next.
 */

import { forget, keysOf, recall, remember } from '../ui/safe-storage.js';
import { keep, recentDocuments } from './recent-documents.js';

/** @typedef {import("./recent-documents.js").Work} Work */
/** @typedef {import("./recent-documents.js").Contents} Contents */

/** With the id of the work: tabs know nothing of each other. */
const KEY = 'shape-up.last-moment ';
/** Longer steps of undo would take the room of the scene: browsers have some five million letters. */
const MOST_BYTES = 1_000_000;

/**
 * @param {Work} work
 * @param {Partial<Contents>} contents what the database does not have yet
 */
export function storeUnsaved(work, contents) {
  const write = (/** @type {string} */ _, /** @type {unknown} */ value) =>
    value instanceof Uint8Array ? lettersOf(value) : value;
  remember(KEY + work.id, JSON.stringify({ work, contents }, write));
}

/** The database has all of a work. @param {string} id */
export function forgetUnsaved(id) {
  forget(KEY + id);
}

/** Brings what was put aside into the database, unless that has something newer. */
export async function recoverUnsaved() {
  for (const key of keysOf(KEY)) {
    const { work, contents } = JSON.parse(recall(key) ?? '{}');
    if (!work) continue;
    for (const part of ['history', 'progress'])
      if (contents[part]) contents[part] = bytesOf(contents[part]);
    const known = (await recentDocuments()).find(({ id }) => id === work.id);
    if (!known || known.savedAt < work.savedAt) await keep(work, contents);
    forget(key);
  }
}

/** @param {Uint8Array} bytes */
function lettersOf(bytes) {
  if (bytes.length > MOST_BYTES) return null;
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

/** @param {string} letters */
function bytesOf(letters) {
  return Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
}
