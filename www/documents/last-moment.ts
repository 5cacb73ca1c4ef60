/**
 * Fallback for saves when the page closes: a browser may drop a pending database write at that
 * moment. The data is written to local storage at once, and to the database on the next visit.
 */

import { getItem, keysOf, removeItem, setItem } from '../ui/safe-storage.ts';
import { keep, recentDocuments, type Work, type Contents } from './recent-documents.ts';

/** Prefix of the key; the id of the work follows, so that tabs do not overwrite each other. */
const KEY = 'shape-up.last-moment ';
/** Longest undo history or progress stored: browsers allow about five million characters, scene included. */
const MOST_BYTES = 1_000_000;

/** @param contents what the database lacks */
export function storeUnsaved(work: Work, contents: Partial<Contents>) {
  // Null deletes what the database has, which is right only if it belongs to an earlier scene.
  const tooLong = 'text' in contents ? null : undefined;
  const write = (_: string, value: unknown) => {
    if (!(value instanceof Uint8Array)) return value;
    return value.length > MOST_BYTES ? tooLong : lettersOf(value);
  };
  setItem(KEY + work.id, JSON.stringify({ work, contents }, write));
}

/** Deletes the fallback copy once the database has all of the work. */
export function forgetUnsaved(id: string) {
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

function lettersOf(bytes: Uint8Array) {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

function bytesOf(letters: string) {
  return Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
}
