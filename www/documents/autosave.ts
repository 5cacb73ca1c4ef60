/**
 * Saves the user's work in this browser, one work per model opened in a tab: immediately after
 * every edit, about once a second during a run or a drag, and the camera, measure and open tab when
 * the page is left. An unchanged example is not saved, since it can be opened again.
 *
 * A tab holds a lock on its work while it lives, so that no other tab opens it.
 */

import { viewOf } from '../viewport/saved-view.ts';
import { getItem, setItem } from '../ui/safe-storage.ts';
import {
  recoverUnsaved,
  forgetUnsaved,
  storeUnsaved,
  LOCK_PREFIX,
  contentsOf,
  newId,
  keep,
  openWorks,
  pruneOldest,
  recentDocuments,
  type Work,
  type Contents,
} from './recent-documents.ts';
import { areSameUnsolved } from './share-link.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Actions } from '../store/actions.ts';
import type { Store } from '../store/state.ts';
import type { Files } from './files.ts';
import type { Saved } from '../solver/types.ts';

/** Key in session storage: the id of this tab's work. */
const OWN_KEY = 'shape-up.work';
/** Key in local storage: set when this browser has saved any work. */
const ANY_KEY = 'shape-up.works';
const OFF = 'Autosave is off: use Save scene';
/** After a reload, the previous page may keep the lock of this tab's work for so long. */
const RELOAD_MS = 2000;

const NOTHING: { text: string | null; progress: Uint8Array | null; view: string } = {
  text: null,
  progress: null,
  view: '',
};

export class Autosave {
  #store;
  #solver;
  #files;
  #actions;
  /** Id of the current work; empty while another model is being opened. */
  #id = '';
  /** The same, kept until that model has opened: its opening may be cancelled. */
  #lastId = '';
  /** Releases the lock. */
  #release: () => void = () => {};
  /** State saved last, or being written to the database. */
  #kept = NOTHING;
  /** State whose write to the database has completed. */
  #confirmed = NOTHING;
  /** Iteration of the latest progress. */
  #reached = 0;
  #writing: Promise<void> | null = null;
  /**
   * What waits for the write before it, by work: it is taken when it comes, since another model may be
   * open when its turn comes.
   */
  #waiting: Map<string, { work: Work; contents: Partial<Contents>; kept: typeof NOTHING }> =
    new Map();

  constructor(solver: SolverClient, files: Files, store: Store, actions: Actions) {
    this.#store = store;
    this.#solver = solver;
    this.#files = files;
    this.#actions = actions;
    solver.on('model', () => {
      // Scenes that arrive before the new model has opened belong to no work, as those of a trial.
      this.#id = solver.restoring && !files.origin.trial ? this.#lastId : '';
    });
    files.on('opened', () => this.#begin());
    solver.on('scene', () => {
      if (this.#id && solver.sceneText !== this.#kept.text) actions.look({ saved: '' });
      void this.save();
    });
    solver.on('progress', ({ iteration }) => {
      this.#reached = iteration;
      void this.save();
    });
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') this.#saveAtOnce();
    });
    window.addEventListener('pagehide', () => this.#saveAtOnce());
    if (store.get().model) void this.#begin();
  }

  /** Id of the current work. */
  get id() {
    return this.#id;
  }

  /** Starts or resumes a work after a model has been opened. */
  async #begin(): Promise<void> {
    const { work, saved, text = null, trial } = this.#files.origin;
    if (trial) return;
    const id = work ?? newId();
    // A model that is reopened continues its work.
    this.#files.origin = { ...this.#files.origin, work: id };
    // The user may already have edited the model since it was opened.
    this.#kept = work && !saved?.progress ? { ...NOTHING, text } : NOTHING;
    this.#confirmed = this.#kept;
    this.#lastId = id;
    // A resumed work was claimed before it was opened. One that is opened again after this tab has let
    // it go may be that of another tab by now: nothing is saved to it before it is claimed.
    this.#id = !work || claims.has(id) ? id : '';
    this.#actions.look({ saved: '' });
    setItem(OWN_KEY, id, 'sessionStorage');
    if (claims.get(id) !== this.#release) this.#release();
    const release = claims.get(id) ?? (await claim(id));
    // Another model has been opened meanwhile: nobody else would let this one go.
    if (this.#lastId !== id) return release?.();
    if (!release) {
      // Both tabs go on, each with a work of its own.
      this.#files.origin = { ...this.#files.origin, work: undefined };
      return this.#begin();
    }
    this.#id = id;
    this.#release = release;
    await this.save();
    await pruneOldest().catch(() => {});
  }

  /** Saves all unsaved changes, including those made while saving. */
  save() {
    const next = this.#takeUnsaved();
    if (next) {
      const [work, contents] = next;
      const before = this.#waiting.get(work.id)?.contents;
      const all = { ...before, ...contents };
      this.#waiting.set(work.id, { work, contents: all, kept: this.#kept });
    }
    this.#writing ??= this.#saveAll().finally(() => {
      this.#writing = null;
      if (this.#waiting.size > 0) void this.save();
    });
    return this.#writing;
  }

  async #saveAll() {
    for (const [id, { work, contents, kept }] of this.#waiting) {
      this.#waiting.delete(id);
      try {
        await keep(work, contents);
        setItem(ANY_KEY, 'yes');
        if (id !== this.#id) continue;
        this.#confirmed = kept;
        if (kept === this.#kept) forgetUnsaved(id);
        const saved = `Saved in this browser ${timeOf(work.savedAt)}`;
        this.#actions.look({ saved });
      } catch {
        // Storage is blocked (as in some private windows) or full; another work may have room. What waits
        // for this one is only what has changed since. If another model is coming, this may come back.
        this.#waiting.delete(id);
        if (id !== this.#lastId) continue;
        this.#kept = NOTHING;
        this.#actions.look({ saved: OFF });
      }
    }
  }

  /** Saves before the page may be closed, including the view. */
  #saveAtOnce() {
    const confirmed = this.#confirmed;
    const next = this.#takeUnsaved(true, confirmed);
    if (!next) return;
    const kept = this.#kept;
    setItem(ANY_KEY, 'yes');
    if (kept.text !== confirmed.text || kept.progress !== confirmed.progress) storeUnsaved(...next);
    const done = () => {
      this.#confirmed = kept;
      if (kept === this.#kept) forgetUnsaved(next[0].id);
    };
    keep(...next).then(done, () => {
      this.#kept = NOTHING;
    });
  }

  /**
   * Returns the difference from the state saved last, and marks it as saved.
   * @param withView also when only the view has changed
   */
  #takeUnsaved(
    withView: boolean = false,
    kept: typeof NOTHING = this.#kept,
  ): [Work, Partial<Contents>] | null {
    const { sceneText: text, saved } = this.#solver;
    const { origin, original, name } = this.#files;
    const { model } = this.#store.get();
    const { history, progress } = saved;
    if (!model || !text || !this.#id) return null;
    const isSame = text === original && !progress;
    if (kept.text === null && isSame && origin.example && !origin.edited) return null;
    const view = viewOf(this.#store.get());
    const viewWords = JSON.stringify(view);
    const isOther = text !== kept.text || progress !== kept.progress;
    if (!isOther && !(withView && viewWords !== kept.view)) return null;
    this.#kept = { text, progress, view: viewWords };
    // The run of a link is nothing that the user has made, unless the link was changed before.
    const isOfLink = origin.file && origin.link && original;
    const isSolved = () => text === kept.text || areSameUnsolved(text, original ?? '');
    origin.changed ||= !(isOfLink && isSolved());
    const isAsItCame = isSame || !origin.changed;
    const work: Work = {
      id: this.#id,
      name,
      title: origin.title ?? (model.title || model.name),
      savedAt: Date.now(),
      iteration: progress ? this.#reached : saved.iteration,
      sceneIteration: saved.iteration,
      example: origin.example?.id ?? null,
      hash: origin.link ?? '',
      view,
      file: isAsItCame ? origin.file : null,
    };
    return [work, text === kept.text ? { progress } : { text, history, progress }];
  }
}

/** Release functions of the works claimed by this tab, by id. */
const claims: Map<string, () => void> = new Map();

/**
 * Claims a work for this tab.
 * @returns the release function; null if another tab has the work
 */
function claim(id: string, how: LockOptions = { ifAvailable: true }): Promise<(() => void) | null> {
  return new Promise((done) => {
    if (!navigator.locks) return done(() => {});
    const hold = (lock: Lock | null) => {
      if (!lock) return done(null);
      return new Promise((end: (value?: unknown) => void) => {
        const release = () => {
          claims.delete(id);
          end();
        };
        claims.set(id, release);
        done(release);
      });
    };
    navigator.locks.request(LOCK_PREFIX + id, how, hold).catch((error) => {
      done(error.name === 'TimeoutError' ? null : () => {});
    });
  });
}

/** Error for a saved work that cannot be opened. */
export class Unreadable extends Error {
  work;
  /** The stored value in place of the scene text. */
  raw;

  constructor(work: Work, raw: unknown, reason: string) {
    super(reason);
    this.work = work;
    this.raw = raw;
  }
}

export type Taken = { work: Work; text: string; saved: Saved };

/**
 * Returns the work to resume when the page opens, claimed: this tab's own work, or the most recent
 * one if no other tab is open.
 * @returns rejects with {@link Unreadable}
 */
export async function lastWork(): Promise<Taken | null> {
  if (!getItem(ANY_KEY)) return null;
  await recoverUnsaved().catch(() => {});
  const mine = getItem(OWN_KEY, 'sessionStorage');
  const list = await recentDocuments();
  const own = list.find(({ id, hash }) => id === mine && hash === location.hash);
  if (own) {
    const taken = await take(own, { signal: AbortSignal.timeout(RELOAD_MS) });
    if (!taken) throw new Error(`${own.title} is open in another tab of this browser.`);
    return taken;
  }
  // A link in the address takes precedence over the last work.
  if (mine || location.hash || (await openWorks()).length > 0) return null;
  const last = list.find(({ unreadable }) => !unreadable);
  return last ? take(last) : null;
}

/**
 * Claims a work and reads its contents, unless another tab has it.
 * @returns rejects with {@link Unreadable}
 */
export async function take(work: Work, how?: LockOptions): Promise<Taken | null> {
  if (!(await claim(work.id, how))) return null;
  const { text, history, progress } = await contentsOf(work.id).catch((error) => {
    release(work);
    throw error;
  });
  if (typeof text !== 'string') {
    await markUnreadable(work);
    throw new Unreadable(work, text, 'its saved copy is damaged');
  }
  const bytes = (value: unknown) => (value instanceof Uint8Array ? value : null);
  const { iteration, sceneIteration = iteration } = work;
  const saved = { iteration: sceneIteration, history: bytes(history), progress: bytes(progress) };
  return { work, text, saved };
}

/** Lets other tabs have a work that was taken, but is not opened. */
export function release({ id }: Work) {
  claims.get(id)?.();
}

/**
 * Releases a work that could not be opened and marks it, so that it is not resumed automatically.
 */
export async function markUnreadable(work: Work) {
  release(work);
  await keep({ ...work, unreadable: true }, {}).catch(() => {});
}

function timeOf(time: number) {
  return new Date(time).toLocaleTimeString('en-GB', { hour: '2-digit', minute: '2-digit' });
}
