/**
 * What the page opens with, and what it keeps: a link, the work of last time, or the first example;
 * then the autosave. All but the choice itself comes when it is needed.
 */

import { messageOf } from './messages.js';
import { recall } from './stored.js';

/** @typedef {import("./files.js").Files} Files */

export class Keeping {
  #store;
  #solver;
  #files;
  #alerts;
  /** @type {Promise<import("./autosave.js").Autosave> | null} */
  #autosave = null;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("./solver-client.js").SolverClient} solver
   * @param {Files} files
   * @param {import("./alerts.js").Alerts} alerts
   */
  constructor(store, solver, files, alerts) {
    this.#store = store;
    this.#solver = solver;
    this.#files = files;
    this.#alerts = alerts;
  }

  /** Opens what the page is to begin with. */
  async begin() {
    window.addEventListener('hashchange', () => this.#told(this.#openLink()));
    try {
      if (await this.#restored()) return;
    } catch {
      // What cannot be read any more is no reason to stay without a model.
    }
    let problem = '';
    const linked = await this.#openLink().catch((error) => {
      problem = messageOf(error);
      return false;
    });
    if (!linked) await this.#openFirst();
    if (problem) this.#alerts.error(problem);
    this.#keepOn();
  }

  /** The first example, or what to do without it. */
  async #openFirst() {
    try {
      await this.startFresh();
    } catch (error) {
      this.#alerts.error(messageOf(error));
      if (this.#solver.isAbsent) return;
      const { showNothingOpen } = await import('./nothing-open.js');
      showNothingOpen(this.#files, async () => {
        await this.#told(this.startFresh());
      });
    }
  }

  /** The model of somebody who comes for the first time. */
  async startFresh() {
    const [example] = await this.#files.examples();
    await this.#files.openExample(example, true);
  }

  /** Everything that has not been saved yet is. */
  async saveNow() {
    await (await this.#autosave)?.save();
  }

  /** The works of this browser that can be opened again. */
  async recent() {
    const { works } = await import('./works.js');
    const current = (await this.#autosave)?.id;
    return (await works()).filter(({ id }) => id !== current);
  }

  /** @param {import("./works.js").Work} work */
  async openWork(work) {
    await this.saveNow();
    const { take } = await import('./autosave.js');
    const taken = await take(work);
    if (!taken) throw new Error(`${work.title} is open in another tab of this browser.`);
    await this.#openWork(taken);
    this.#store.set({ status: `Opened ${work.title}` });
  }

  #keepOn() {
    const [store, solver, files] = [this.#store, this.#solver, this.#files];
    this.#autosave ??= import('./autosave.js').then(
      ({ Autosave }) => new Autosave(store, solver, files),
    );
    this.#autosave.catch(() => store.set({ saved: 'Autosave is off: use Save scene' }));
  }

  /** Goes on where this tab was, if it was anywhere. @returns {Promise<boolean>} */
  async #restored() {
    if (!wasHere()) return false;
    const { lastWork } = await import('./autosave.js');
    const last = await lastWork();
    if (!last) return false;
    await this.#openWork(last);
    this.#keepOn();
    const fresh = () => {
      if (location.hash) history.replaceState(null, '', location.pathname + location.search);
      this.#told(this.startFresh());
    };
    this.#alerts.notice(`${last.work.title} is back as you left it.`, {
      label: 'Start fresh',
      action: fresh,
    });
    return true;
  }

  /** @param {{ work: import("./works.js").Work, text: string }} taken */
  async #openWork({ work, text }) {
    const bytes = new TextEncoder().encode(text);
    const examples = work.example ? await this.#files.examples() : [];
    const example = examples.find(({ id }) => id === work.example);
    const { id, title, iteration } = work;
    const origin = { example, work: id, title, iteration };
    await this.#files.open([{ name: `${work.name}.shapeup.json`, bytes }], origin);
  }

  /** Opens what the address links to. @returns {Promise<boolean>} whether it links to anything */
  async #openLink() {
    if (location.hash.length < 2) return false;
    const { readLink, unpack } = await import('./share-link.js');
    const link = readLink(location.hash);
    if (!link) return false;
    const text = link.code && (await unpack(link.code));
    if (link.example) await this.#openExample(link.example, text);
    else if (text) await this.#files.open([sceneFile('shared', text)]);
    if (link.run) this.#solver.tell({ type: 'run' });
    return true;
  }

  /**
   * @param {string} id
   * @param {string | null} edits the text of the scene instead of the example's own
   */
  async #openExample(id, edits) {
    const examples = await this.#files.examples();
    const example = examples.find((one) => one.id === id);
    if (!example)
      throw new Error(`There is no example called ${id}: the link is an old one or wrong.`);
    if (!edits) return this.#files.openExample(example);
    const mesh = { name: example.mesh, bytes: await this.#files.exampleFile(example.mesh) };
    await this.#files.open([sceneFile(example.id, edits), mesh], { example });
    // What differs from the example is in the link only.
    this.#files.original = null;
  }

  /**
   * @template T
   * @param {Promise<T>} promise
   * @returns {Promise<T | undefined>}
   */
  async #told(promise) {
    try {
      return await promise;
    } catch (error) {
      this.#alerts.error(messageOf(error));
      return undefined;
    }
  }
}

/**
 * @param {string} name
 * @param {string} text
 */
function sceneFile(name, text) {
  return { name: `${name}.shapeup.json`, bytes: new TextEncoder().encode(text) };
}

/** Whether anything was ever kept in this browser. */
const wasHere = () => recall('shape-up.works') !== null;
