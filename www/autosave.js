/**
 * Keeps what is worked on in this browser, one work per model that was opened in a tab. It saves
 * when nothing has changed for a while and the solver rests; what could be opened again anyway, an
 * example as it comes, is not saved.
 *
 * A tab holds a lock on its work as long as it lives, so that no other tab takes it up.
 */

import { recall, remember } from './stored.js';
import { keep, textOf, works } from './works.js';

/** @typedef {import("./works.js").Work} Work */

/** Nothing has changed for so long, in milliseconds. */
const IDLE_MS = 1500;
const LOCK = 'shape-up.work.';
/** Per tab: its work. */
const MINE = 'shape-up.work';
/** In this browser: there is some. */
const ANY = 'shape-up.works';
const OFF = 'Autosave is off: use Save scene';

export class Autosave {
  #store;
  #solver;
  #files;
  #id = '';
  /** Lets go of the lock. @type {() => void} */
  #release = () => {};
  #timer = 0;
  /** What was saved last. @type {string | null} */
  #saved = null;
  /** The address that the model was opened at. */
  #hash = '';

  /**
   * @param {import("./state.js").Store} store
   * @param {import("./solver-client.js").SolverClient} solver
   * @param {import("./files.js").Files} files
   */
  constructor(store, solver, files) {
    this.#store = store;
    this.#solver = solver;
    this.#files = files;
    files.addEventListener('opened', () => this.#begin());
    solver.addEventListener('scene', () => this.#later());
    store.subscribe(['running', 'dragged'], () => this.#later());
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') this.save();
    });
    if (store.get().model) this.#begin();
  }

  /** The name of the work that is open. */
  get id() {
    return this.#id;
  }

  /** Another model is open: a work of its own, or one that goes on. */
  async #begin() {
    const { work } = this.#files.origin;
    this.#hash = location.hash;
    this.#saved = work ? this.#solver.sceneText : null;
    this.#id = work ?? newId();
    this.#store.set({ saved: '' });
    remember(MINE, this.#id, 'sessionStorage');
    this.#release();
    // One that goes on was claimed before it was opened.
    this.#release = claims.get(this.#id) ?? (await claim(this.#id)) ?? (() => {});
    this.#later();
  }

  #later() {
    clearTimeout(this.#timer);
    const { running, dragged } = this.#store.get();
    if (this.#solver.sceneText !== this.#saved) this.#store.set({ saved: '' });
    if (!running && dragged.length === 0) this.#timer = setTimeout(() => this.save(), IDLE_MS);
  }

  /** Saves now, if there is anything to save. */
  async save() {
    clearTimeout(this.#timer);
    const text = this.#solver.sceneText;
    const { origin, original, name } = this.#files;
    const { model } = this.#store.get();
    if (!model || !text || !this.#id || text === this.#saved) return;
    if (this.#saved === null && origin.example && text === original) return;
    this.#saved = text;
    const savedAt = Date.now();
    /** @type {Work} */
    const work = {
      id: this.#id,
      name,
      title: origin.title ?? (model.title || model.name),
      savedAt,
      iteration: this.#solver.sceneIteration,
      example: origin.example?.id ?? null,
      hash: this.#hash,
    };
    try {
      await keep(work, text);
      remember(ANY, 'yes');
      this.#store.set({ saved: `Saved in this browser ${timeOf(savedAt)}` });
    } catch {
      // Blocked, as in some private windows, or full.
      this.#saved = null;
      this.#store.set({ saved: OFF });
    }
  }
}

/** Works that this tab holds. @type {Map<string, () => void>} */
const claims = new Map();

/**
 * Takes a work for this tab.
 * @param {string} id
 * @returns {Promise<(() => void) | null>} lets go of it; null when another tab has it
 */
function claim(id) {
  return new Promise((done) => {
    if (!navigator.locks) return done(() => {});
    const hold = (/** @type {Lock | null} */ lock) => {
      if (!lock) return done(null);
      return new Promise((/** @type {(value?: unknown) => void} */ end) => {
        const release = () => {
          claims.delete(id);
          end();
        };
        claims.set(id, release);
        done(release);
      });
    };
    navigator.locks.request(LOCK + id, { ifAvailable: true }, hold).catch(() => done(() => {}));
  });
}

/**
 * The work to go on with when the page opens: this tab's own, or the last one when no other tab is
 * open. It is claimed.
 * @returns {Promise<{ work: Work, text: string } | null>}
 */
export async function lastWork() {
  if (!recall(ANY)) return null;
  const mine = recall(MINE, 'sessionStorage');
  const list = await works();
  const own = list.find(({ id, hash }) => id === mine && hash === location.hash);
  // Somebody who opens a link wants what it links to.
  if (!own && (mine || location.hash || (await othersAreOpen()))) return null;
  return take(own ?? list[0]);
}

/**
 * A work with its text, if it is there and free.
 * @param {Work | undefined} work
 */
export async function take(work) {
  const text = work && (await textOf(work.id));
  return work && text && (await claim(work.id)) ? { work, text } : null;
}

async function othersAreOpen() {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  return held.some(({ name }) => name?.startsWith(LOCK));
}

function newId() {
  return `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
}

/** @param {number} time */
export function timeOf(time) {
  return new Date(time).toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' });
}
