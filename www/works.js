/**
 * What is kept in this browser: the scenes that were worked on, newest first. The list is small and
 * is read at once; the texts are beside it, each under its own name.
 */

import { createStore, del, get, set, update } from 'idb-keyval';

/**
 * @typedef {object} Work
 * @property {string} id
 * @property {string} name base name of its files
 * @property {string} title
 * @property {number} savedAt milliseconds since 1970
 * @property {number} iteration
 * @property {string | null} example id of the example whose mesh it has
 * @property {string} hash of the address that it was opened at
 */

const LIST = 'list';
/** So many are kept. */
const MOST = 8;
const database = createStore('shape-up', 'works');

/** The newest first. @returns {Promise<Work[]>} */
export async function works() {
  return (await get(LIST, database)) ?? [];
}

/** The text of a scene. @param {string} id @returns {Promise<string | undefined>} */
export function textOf(id) {
  return get(`text ${id}`, database);
}

/**
 * Keeps a work, and forgets the oldest of too many. When there is no room, all others go.
 * @param {Work} work
 * @param {string} text of its scene
 */
export async function keep(work, text) {
  try {
    await write(work, text, MOST);
  } catch (error) {
    if (!(error instanceof DOMException && error.name === 'QuotaExceededError')) throw error;
    await shorten([work], 1);
    await write(work, text, 1);
  }
}

/**
 * @param {Work} work
 * @param {string} text
 * @param {number} most
 */
async function write(work, text, most) {
  await set(`text ${work.id}`, text, database);
  await shorten([work], most);
}

/**
 * Puts works at the head of the list, which then has at most so many.
 * @param {Work[]} first
 * @param {number} most
 */
async function shorten(first, most) {
  /** @type {Work[]} */
  let gone = [];
  // One transaction: another tab may be doing the same.
  await update(
    LIST,
    (/** @type {Work[] | undefined} */ list = []) => {
      const ids = first.map(({ id }) => id);
      const all = [...first, ...list.filter(({ id }) => !ids.includes(id))];
      gone = all.slice(most);
      return all.slice(0, most);
    },
    database,
  );
  await Promise.all(gone.map(({ id }) => del(`text ${id}`, database)));
}
