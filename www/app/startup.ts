/**
 * Opens the first document of the page (that of a link, the last work, or the first example) and
 * starts autosave.
 */

import '../ui/styles/waiting.css';
import {
  Autosave,
  Unreadable,
  lastWork,
  markUnreadable,
  release,
  take,
  type Taken,
} from '../documents/autosave.ts';
import { MOST, recentDocuments, removals, type Work } from '../documents/recent-documents.ts';
import { readLink } from '../documents/share-link.ts';
import { Cancelled, messageOf } from '../solver/errors.ts';
import { exampleOf } from '../solver/examples.ts';
import { byId, element } from '../ui/dom.ts';
import { isEmbedded } from '../ui/embedded.ts';
import { saveFile } from '../ui/output.ts';
import { removeFirstPicture } from '../viewport/placeholder.ts';
import type { Files } from '../documents/files.ts';
import type { AppContext } from './context.ts';
import type { Opening } from '../documents/openings.ts';
import type { Opened } from '../solver/types.ts';

export class Startup {
  #store;
  #actions;
  #solver;
  #files;
  #alerts;
  #autosave: Autosave | null = null;

  constructor({
    store,
    actions,
    solver,
    files,
    alerts,
  }: Pick<AppContext, 'store' | 'actions' | 'solver' | 'files' | 'alerts'>) {
    this.#store = store;
    this.#actions = actions;
    this.#solver = solver;
    this.#files = files;
    this.#alerts = alerts;
    removals.on('beyond', (titles) => {
      const all = titles.map((title) => `“${title}”`).join(', ');
      alerts.notice(
        `Only the last ${MOST} models that you changed are kept: removed from Open recent ${all}.`,
      );
    });
  }

  /** Opens the first document, unless the user opens another one meanwhile. */
  async begin() {
    const { openings } = this.#files;
    // Before it is told, a document that has just been opened may have put its own name there.
    window.addEventListener('hashchange', ({ newURL }) =>
      this.#actions.reportErrors(openings.begin((own) => this.#follow(own, new URL(newURL).hash))),
    );
    await openings.begin((own) => this.#begin(own));
  }

  async #begin(opening: Opening) {
    let lost: unknown = null;
    try {
      if (await this.#restored(opening)) return;
    } catch (error) {
      // Continue, so that the page does not stay without a model.
      lost = error;
    }
    // Start autosave before opening, so that the first edits are saved even if the page closes
    // soon.
    this.#startAutosave();
    let problem = '';
    const linked = await this.#openLink(opening, location.hash).catch((error) => {
      problem = error instanceof Cancelled ? '' : messageOf(error);
      return false;
    });
    if (!linked) await this.#openFirst(opening);
    if (problem && (await opening.isWanted())) this.#alerts.error(problem);
    if (lost) this.#reportUnreadable(lost);
  }

  /** Opens the first example, or explains how to continue without it. */
  async #openFirst(opening: Opening) {
    try {
      await this.#startFresh(opening);
    } catch (error) {
      if (!(await opening.isWanted())) return;
      if (!(error instanceof Cancelled)) this.#alerts.error(messageOf(error));
      if (this.#solver.isAbsent) return;
      this.#actions.look({ nothingOpen: true });
      showNothingOpen(this.#files, async () => {
        await this.#actions.reportErrors(this.#startFresh());
      });
    }
  }

  /**
   * Opens the model that first-time visitors get.
   * @param within the opening that it is part of, if it is not one of its own
   */
  async #startFresh(within?: Opening): Promise<void> {
    const { openings } = this.#files;
    if (!within) return void (await openings.begin((own) => this.#startFresh(own)));
    const [example] = await this.#files.examples();
    await this.#files.openExample(example, { first: true, opening: within });
  }

  /** Saves all unsaved changes. */
  async saveNow() {
    await this.#actions.settled();
    await this.#autosave?.save();
  }

  /** Returns the works stored in this browser, except the current one; waits for no opening. */
  async recent() {
    await this.#autosave?.save();
    const current = this.#autosave?.id;
    return (await recentDocuments()).filter(({ id }) => id !== current);
  }

  /** Opens a work chosen by the user, or reports why it cannot be opened. */
  async openWork(work: Work) {
    await this.#files.openings.begin((own) => this.#openChosen(work, own));
  }

  async #openChosen(work: Work, opening: Opening) {
    const { title } = work;
    try {
      await this.saveNow();
      const taken = await take(work);
      if (!taken) throw new Error(`${title} is open in another tab of this browser.`);
      const loaded = await this.#openWork(taken, opening);
      if (!loaded) return;
      const { undoLost } = loaded;
      this.#actions.setStatus(`Opened ${title}`);
      if (undoLost) this.#alerts.notice(`The undo history of ${title} is lost: ${undoLost}.`);
    } catch (error) {
      if (await opening.isWanted()) this.#reportUnreadable(error);
    }
  }

  /** Reports that a work cannot be opened, and offers to save its file. */
  #reportUnreadable(error: unknown) {
    if (error instanceof Cancelled) return;
    if (!(error instanceof Error && 'work' in error && 'raw' in error)) {
      return this.#alerts.error(messageOf(error));
    }
    const { raw } = error;
    const { title, name } = error.work as Work;
    const text = typeof raw === 'string' ? raw : (JSON.stringify(raw) ?? '');
    const words = `${title} is saved in this browser, but cannot be opened: ${messageOf(error)}.`;
    this.#alerts.error(words.replace(/\.\.$/, '.'), {
      label: 'Save its file',
      action: () => saveFile(`${name}.shapeup.json`, text, 'application/json'),
    });
  }

  #startAutosave() {
    if (isEmbedded) return;
    this.#autosave ??= new Autosave(this.#solver, this.#files, this.#store, this.#actions);
  }

  /**
   * Restores the last work of this tab, if any.
   * @returns whether there is one
   */
  async #restored(opening: Opening): Promise<boolean> {
    const last = await lastWork();
    if (!last) return false;
    // Autosave must be running before the user can edit the work and close the page.
    this.#startAutosave();
    const loaded = await this.#openWork(last, opening);
    if (!loaded) return true;
    const { undoLost } = loaded;
    const fresh = () => {
      void this.#actions.reportErrors(this.#startFresh());
    };
    const words = undoLost ? `is back, but its undo history is lost: ${undoLost}` : 'is back';
    this.#alerts.notice(`${last.work.title} ${words}.`, {
      label: 'Start fresh',
      action: fresh,
    });
    return true;
  }

  /** @returns null if a later opening has taken its place: other tabs can have the work then */
  async #openWork(taken: Taken, opening: Opening) {
    let loaded: Opened | null = null;
    try {
      loaded = await this.#reopen(taken, opening);
    } finally {
      if (!loaded) release(taken.work);
    }
    return loaded;
  }

  async #reopen({ work, text, saved }: Taken, opening: Opening): Promise<Opened | null> {
    const bytes = new TextEncoder().encode(text);
    // The work has all that it needs: without a network it comes back without the note on its example.
    const examples = work.example ? await this.#files.examples().catch(() => []) : [];
    const example = examples.find(({ id }) => id === work.example);
    const { id, title, hash: link, view, file } = work;
    const about = { example, edited: true, title, link, view, file };
    const origin = { ...about, work: id, saved, text };
    const files = [{ name: `${work.name}.shapeup.json`, bytes }];
    return this.#files.open(files, origin, { opening }).catch(async (error) => {
      // Neither says anything about the work.
      if (error instanceof Cancelled || this.#solver.isAbsent) throw error;
      await markUnreadable(work);
      throw new Unreadable(work, text, messageOf(error));
    });
  }

  /** Opens the link that the address has become. If it is none, the open model keeps its own. */
  async #follow(opening: Opening, hash: string) {
    let isOpen = false;
    try {
      isOpen = await this.#openLink(opening, hash);
    } finally {
      if (!isOpen && this.#store.get().model && (await opening.isWanted()))
        this.#files.nameInAddress();
    }
  }

  /**
   * Opens the document of the link, if any.
   * @param hash of the address; that may change again while the link is read
   * @returns whether there is one
   */
  async #openLink(opening: Opening, hash: string): Promise<boolean> {
    if (hash.length < 2) return false;
    const link = await readLink(hash);
    if (!link) return false;
    const { example, text, run, name } = link;
    const from = { link: hash };
    let loaded: Opened | null = null;
    if (example) loaded = await this.#openExample(example, text, from, opening);
    else if (text)
      loaded = await this.#files.open([sceneFile(name ?? 'shared', text)], from, { opening });
    if (loaded && run) this.#solver.tell.run();
    return true;
  }

  /** @param edits text of a scene that replaces the scene of the example */
  async #openExample(id: string, edits: string | null, from: { link: string }, opening: Opening) {
    const example = exampleOf(await this.#files.examples(), id);
    if (!edits) return this.#files.openExample(example, { ...from, opening });
    const mesh = { name: example.mesh, bytes: await this.#files.exampleFile(example.mesh) };
    const files = [sceneFile(example.id, edits), mesh];
    return this.#files.open(files, { ...from, example, edited: true }, { opening });
  }
}

function sceneFile(name: string, text: string) {
  return { name: `${name}.shapeup.json`, bytes: new TextEncoder().encode(text) };
}

const FILES = 'a mesh (.obj, .off, .mesh, .ply, .stl, .3dm) or a scene (.json)';

/**
 * Shows what can be opened where not even the first example could be fetched, until a model is opened.
 * @param again opens the first example
 */
function showNothingOpen(files: Files, again: () => Promise<void>) {
  removeFirstPicture();
  const card = element(
    'div',
    { id: 'nothing-open' },
    element('p.with-drop', `Drop ${FILES} here.`),
    element('p.without-drop', `Open ${FILES}.`),
    element('button.bordered', { onclick: again }, 'Open an example'),
  );
  byId('main').append(card);
  files.once('opened', () => card.remove());
}
