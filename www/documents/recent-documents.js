/**
 * What is kept in this browser: the scenes that were worked on. Each has a few records of its own, and a
 * list is made of what is there, so that no damage to one is a damage to others.
 */

import { createStore, promisifyRequest } from 'idb-keyval';

/**
 * @typedef {object} Work
 * @property {string} id
 * @property {string} name base name of its files
 * @property {string} title
 * @property {number} savedAt milliseconds since 1970
 * @property {number} iteration
 * @property {string | null} example id of the example whose mesh it has
 * @property {string} hash of the address that it was opened at
 * @property {import("../viewport/saved-view.js").SavedView | null} view how it was looked at
 * @property {boolean} [unreadable] it could not be opened
 */

/**
 * What a work consists of: the text of its scene, the steps of undo that belong to it, and how far a run
 * or a drag has come that began with it. Null where there is none.
 * @typedef {object} Contents
 * @property {string} text
 * @property {Uint8Array | null} history
 * @property {Uint8Array | null} progress
 */

/** Keys are a part and the id of a work. */
const ABOUT = 'work ';
const TEXT = 'text ';
const PARTS = [ABOUT, TEXT, 'history ', 'progress '];
/** Versions before this one had a list instead. */
const OLD_LIST = 'list';
/** So many are kept. */
const MOST = 8;
const database = createStore('shape-up', 'works');

/** The newest first. @returns {Promise<Work[]>} */
export async function recentDocuments() {
  const [keys, about, old] = await database('readonly', (store) =>
    Promise.all([
      promisifyRequest(store.getAllKeys()),
      promisifyRequest(store.getAll(IDBKeyRange.bound(ABOUT, `${ABOUT}\uffff`))),
      promisifyRequest(store.get(OLD_LIST)),
    ]),
  );
  const known = [...(Array.isArray(old) ? old : []), ...about].filter(isWork);
  const byId = new Map(known.map((work) => [work.id, work]));
  return keys
    .map(String)
    .filter((key) => key.startsWith(TEXT))
    .map((key) => key.slice(TEXT.length))
    .map((id) => byId.get(id) ?? unknown(id))
    .sort((a, b) => b.savedAt - a.savedAt);
}

/** @param {string} id @returns {Promise<{ [part in keyof Contents]: unknown }>} as it is there, be it damaged */
export async function contentsOf(id) {
  const parts = PARTS.slice(1).map((part) => part + id);
  const [text, history, progress] = await database('readonly', (store) =>
    Promise.all(parts.map((key) => promisifyRequest(store.get(key)))),
  );
  return { text, history, progress };
}

/**
 * Keeps a work and those of its contents that are named, all at once or nothing. When there is no room,
 * all others go.
 * @param {Work} work
 * @param {Partial<Contents>} contents
 */
export async function keep(work, contents) {
  try {
    await write(work, contents);
  } catch (error) {
    if (!(error instanceof DOMException && error.name === 'QuotaExceededError')) throw error;
    await deleteExcept(({ id }) => id === work.id);
    await write(work, contents);
  }
}

/**
 * Forgets the oldest of too many.
 * @param {(id: string) => boolean} isOpen in a tab
 */
export async function pruneOldest(isOpen) {
  const newest = (await recentDocuments()).slice(0, MOST).map(({ id }) => id);
  await deleteExcept(({ id }) => newest.includes(id) || isOpen(id));
}

/** @param {(work: Work) => boolean} stays */
async function deleteExcept(stays) {
  const gone = (await recentDocuments()).filter((work) => !stays(work));
  if (gone.length === 0) return;
  await database('readwrite', (store) => {
    for (const { id } of gone) for (const part of PARTS) store.delete(part + id);
    return promisifyRequest(store.transaction);
  });
}

/**
 * @param {Work} work
 * @param {Partial<Contents>} contents
 */
function write(work, contents) {
  return database('readwrite', (store) => {
    store.put(work, ABOUT + work.id);
    for (const [part, value] of Object.entries(contents)) {
      const key = `${part} ${work.id}`;
      if (value === null) store.delete(key);
      else store.put(value, key);
    }
    // From here on the browser needs no more of this page, which may be about to go.
    store.transaction.commit?.();
    return promisifyRequest(store.transaction);
  });
}

/** @param {any} value @returns {value is Work} */
function isWork(value) {
  const words = [value?.id, value?.name, value?.title, value?.hash];
  const numbers = [value?.savedAt, value?.iteration];
  return words.every((word) => typeof word === 'string') && numbers.every(Number.isFinite);
}

/** A scene of which nothing else is known but when its work began. @param {string} id @returns {Work} */
function unknown(id) {
  const begun = Number.parseInt(id, 36);
  const savedAt = begun < Date.now() ? begun : 0;
  return {
    ...{ id, name: 'recovered', title: 'Recovered model', savedAt, iteration: 0 },
    ...{ example: null, hash: '', view: null },
  };
}
