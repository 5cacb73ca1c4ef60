/**
 * Scenes saved in this browser's database. Each has its own records, and the list is derived from
 * the existing records, so that a damaged record affects no other scene.
 */

import { createStore, promisifyRequest } from 'idb-keyval';
import { Emitter } from '../solver/emitter.ts';
import { getItem, keysOf, removeItem, setItem } from '../ui/safe-storage.ts';
import type { SavedView } from '../viewport/saved-view.ts';

export interface Work {
  id: string;
  /** base name of its files */
  name: string;
  title: string;
  /** milliseconds since 1970 */
  savedAt: number;
  iteration: number;
  /** that of its scene, from which a run or a drag has gone on; the same if it is not there */
  sceneIteration?: number;
  /** id of the example whose mesh it has */
  example: string | null;
  /** fragment of the address at which it was opened */
  hash: string;
  /** camera, measure and open tab */
  view: SavedView | null;
  /** opening it failed */
  unreadable?: boolean;
  /** digest of the file that it was opened from, if it was not changed since: it can be opened again */
  file?: string | null;
}

/**
 * Contents of a work: the text of its scene, its undo history, and the progress of a run or a drag
 * that started from that scene; null if there is none.
 */
export interface Contents {
  text: string;
  history: Uint8Array | null;
  progress: Uint8Array | null;
}

/** A key consists of a part's prefix and the id of a work. */
const ABOUT = 'work ';
const TEXT = 'text ';
const PARTS = [ABOUT, TEXT, 'history ', 'progress '];
/** Number of works kept, beside older ones that are open. */
export const MOST = 8;
/** A tab holds a lock with this prefix and the id of its work. */
export const LOCK_PREFIX = 'shape-up.work.';
const database = createStore('shape-up', 'works');

/** Tells which changed works, by their titles, were beyond the limit. */
export const removals = new Emitter<{ beyond: string[] }>();

/** Returns the id of a work that begins now. */
export const newId = () => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

/** Returns all works, newest first. */
export async function recentDocuments(): Promise<Work[]> {
  const [keys, about] = await database('readonly', (store) =>
    Promise.all([
      promisifyRequest(store.getAllKeys()),
      promisifyRequest(store.getAll(IDBKeyRange.bound(ABOUT, `${ABOUT}\uffff`))),
    ]),
  );
  const byId = new Map(about.filter(isWork).map((work) => [work.id, work]));
  return keys
    .map(String)
    .filter((key) => key.startsWith(TEXT))
    .map((key) => key.slice(TEXT.length))
    .map((id) => byId.get(id) ?? unknown(id))
    .sort((a, b) => b.savedAt - a.savedAt);
}

/** Reads the stored contents of a work without checking them. */
export async function contentsOf(id: string): Promise<{ [part in keyof Contents]: unknown }> {
  const parts = PARTS.slice(1).map((part) => part + id);
  const [text, history, progress] = await database('readonly', (store) =>
    Promise.all(parts.map((key) => promisifyRequest(store.get(key)))),
  );
  return { text, history, progress };
}

/** Stores a work and the given parts of its contents in one transaction. */
export function keep(work: Work, contents: Partial<Contents>) {
  return database('readwrite', (store) => {
    store.put(work, ABOUT + work.id);
    for (const [part, value] of Object.entries(contents)) {
      const key = `${part} ${work.id}`;
      if (value === null) store.delete(key);
      else if (value !== undefined) store.put(value, key);
    }
    // Commit now: the page may be closed before the transaction would commit by itself.
    store.transaction.commit?.();
    return done(store.transaction);
  });
}

/**
 * Deletes works beyond the limit, except those that are open: first those that can be opened again from
 * their files, then those of links that were not changed, then the oldest. Of what was not changed there
 * is only the newest of each file or link.
 */
export async function pruneOldest() {
  const all = await recentDocuments();
  const newest = all.filter(
    ({ id, file }) => !file || all.find((one) => one.file === file)?.id === id,
  );
  // Who was sent a link may have no other copy.
  const isOfFile = ({ file, hash }: Work) => Boolean(file) && !hash;
  const [ofFiles, others] = [isOfFile, (work: Work) => !isOfFile(work)].map((is) =>
    newest.filter(is),
  );
  // What was changed exists nowhere else.
  const [ofLinks, changed] = [true, false].map((is) =>
    others.filter(({ file }) => Boolean(file) === is),
  );
  const kept = [...changed, ...ofLinks, ...ofFiles].slice(0, MOST).map(({ id }) => id);
  const removed = (await closedWorks()).filter(({ id }) => !kept.includes(id));
  await remove(removed);
  const isTold = ({ id }: Work) => others.some((other) => other.id === id);
  const titles = removed.filter(isTold).map(({ title }) => title);
  if (titles.length > 0) removals.emit('beyond', titles);
}

/** Returns the ids of the works that are open in this tab or another one. */
export async function openWorks() {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  return held.flatMap(({ name }) => name?.split(LOCK_PREFIX)[1] ?? []);
}

/** Returns the works that no tab has open, newest first. */
async function closedWorks() {
  const open = await openWorks();
  return (await recentDocuments()).filter(({ id }) => !open.includes(id));
}

async function remove(works: Work[]) {
  if (works.length === 0) return;
  await database('readwrite', (store) => {
    for (const { id } of works) for (const part of PARTS) store.delete(part + id);
    return done(store.transaction);
  });
}

/** Waits for the end of a transaction: it has no reason yet when the error of a request reaches it. */
const done = (transaction: IDBTransaction) =>
  new Promise<void>((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error ?? new Error('Aborted.'));
  });

function isWork(value: unknown): value is Work {
  const work: Partial<Work> = value ?? {};
  const words = [work.id, work.name, work.title, work.hash];
  const numbers = [work.savedAt, work.iteration];
  return words.every((word) => typeof word === 'string') && numbers.every(Number.isFinite);
}

/** Returns the record of a scene without one; its id contains the time at which the work began. */
function unknown(id: string): Work {
  const begun = Number.parseInt(id, 36);
  const savedAt = begun < Date.now() ? begun : 0;
  return {
    ...{ id, name: 'recovered', title: 'Recovered model', savedAt, iteration: 0 },
    ...{ example: null, hash: '', view: null },
  };
}

/**
 * Fallback for saves when the page closes: a browser may drop a pending database write at that
 * moment. The data is written to local storage at once, and to the database on the next visit. This
 * is the prefix of its key; the id of the work follows, so that tabs do not overwrite each other.
 */
const LAST_MOMENT = 'shape-up.last-moment ';
/** Longest undo history or progress stored: browsers allow about five million characters, scene included. */
const MOST_BYTES = 1_000_000;

/**
 * Stores what the database lacks.
 * @param contents of the work
 */
export function storeUnsaved(work: Work, contents: Partial<Contents>) {
  // Null deletes what the database has, which is right only if it belongs to an earlier scene.
  const tooLong = 'text' in contents ? null : undefined;
  const write = (_: string, value: unknown) => {
    if (!(value instanceof Uint8Array)) return value;
    return value.length > MOST_BYTES ? tooLong : lettersOf(value);
  };
  setItem(LAST_MOMENT + work.id, JSON.stringify({ work, contents }, write));
}

/** Deletes the fallback copy once the database has all of the work. */
export function forgetUnsaved(id: string) {
  removeItem(LAST_MOMENT + id);
}

/**
 * Moves the fallback copies into the database, unless its record is newer. One for which there is no
 * room yet, or a damaged one, holds up no other.
 */
export async function recoverUnsaved() {
  for (const key of keysOf(LAST_MOMENT)) {
    try {
      const copy = fallbackCopy(getItem(key) ?? '');
      if (copy) await keepIfNewer(copy.work, copy.contents);
      removeItem(key);
    } catch {
      // It is tried again on the next visit.
    }
  }
}

/** Reads a fallback copy; null if it is damaged. */
function fallbackCopy(text: string): { work: Work; contents: Partial<Contents> } | null {
  try {
    const { work, contents } = JSON.parse(text);
    for (const part of ['history', 'progress'])
      if (contents[part]) contents[part] = bytesOf(contents[part]);
    return isWork(work) ? { work, contents } : null;
  } catch {
    return null;
  }
}

async function keepIfNewer(work: Work, contents: Partial<Contents>) {
  const known = (await recentDocuments()).find(({ id }) => id === work.id);
  if (!known || known.savedAt < work.savedAt) await keep(work, contents);
}

function lettersOf(bytes: Uint8Array) {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

function bytesOf(letters: string) {
  return Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
}
