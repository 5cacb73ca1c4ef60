/** Files in and out: open, drop, save and export. */

import { count } from './format.js';
import { element } from './dom.js';
import { nameInAddress } from './example-links.js';
import { filesOf } from './examples.js';
import { removeFirstPicture } from './first-picture.js';
import { messageOf } from './messages.js';

/** @typedef {import("./messages.js").NamedBytes} NamedBytes */
/** @typedef {import("./examples.js").Example} Example */

const READABLE = /\.(obj|off|mesh|json)$/i;
const IS_SCENE = /\.json$/i;

export class Files {
  #store;
  #solver;
  #alerts;
  /** Base name for what is saved. */
  #name = 'model';

  /**
   * @param {import("./state.js").Store} store
   * @param {import("./solver-client.js").SolverClient} solver
   * @param {import("./alerts.js").Alerts} alerts
   */
  constructor(store, solver, alerts) {
    this.#store = store;
    this.#solver = solver;
    this.#alerts = alerts;
  }

  /**
   * Opens a mesh or a scene, with the mesh that the scene names beside it. When it is refused the
   * old model stays and the alert says why.
   * @param {NamedBytes[]} files
   * @param {boolean} [first] it is what the page opens with
   * @returns {Promise<import("./messages.js").Loaded>} rejects with what the alert says
   */
  async open(files, first = false) {
    try {
      const unreadable = files.find((file) => !READABLE.test(file.name));
      if (unreadable) {
        throw new Error(
          `${unreadable.name}: this kind of file cannot be read. Open .obj, .off or .mesh for a mesh, .json for a scene.`,
        );
      }
      this.#store.set({ status: `Reading ${files.map((file) => file.name).join(' and ')} …` });
      const loaded = await this.#solver.request({ type: 'open', files });
      const main = files.find((file) => IS_SCENE.test(file.name)) ?? files[0];
      this.#name = main.name.replace(/(\.shapeup)?\.[^.]+$/, '');
      this.#alerts.clear();
      if (!first) removeFirstPicture();
      nameInAddress(null);
      this.#store.set({
        example: null,
        firstExample: first,
        status: `Opened ${main.name}: ${count(loaded.vertices, 'vertex', 'vertices')}, ${count(loaded.faces, 'face')}`,
      });
      return loaded;
    } catch (error) {
      this.#store.set({ status: '' });
      this.#alerts.error(messageOf(error));
      throw error;
    }
  }

  /**
   * What a file input or a drop gives.
   * @param {Iterable<File>} chosen
   */
  async openFiles(chosen) {
    const files = await Promise.all(
      [...chosen].map(async (file) => ({
        name: file.name,
        bytes: new Uint8Array(await file.arrayBuffer()),
      })),
    );
    if (files.length > 0) await this.open(files).catch(() => {});
  }

  /**
   * @param {Example} example
   * @param {import("./state.js").Beside} beside
   * @param {boolean} [first] it is what the page opens with
   */
  async openExample(example, beside, first = false) {
    await this.open(await filesOf(example), first);
    this.#store.set({
      example: { ...example, beside },
      status: first ? '' : `Opened the example ${example.title}`,
    });
  }

  /** Drops anywhere on the window open; the overlay says what will happen. @param {HTMLElement} overlay */
  acceptDrops(overlay) {
    const carriesFiles = (/** @type {DragEvent} */ event) =>
      event.dataTransfer?.types.includes('Files') ?? false;
    window.addEventListener('dragover', (event) => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      overlay.hidden = false;
    });
    window.addEventListener('dragleave', (event) => {
      if (!event.relatedTarget) overlay.hidden = true;
    });
    window.addEventListener('drop', (event) => {
      overlay.hidden = true;
      if (!carriesFiles(event)) return;
      event.preventDefault();
      this.openFiles(event.dataTransfer?.files ?? []);
    });
  }

  /** The current shape, as the solver's host writes it everywhere. */
  async exportMesh() {
    try {
      const text = await this.#solver.request({ type: 'obj' });
      this.#save(`${this.#name}.obj`, text, 'model/obj');
    } catch (error) {
      this.#alerts.error(messageOf(error));
    }
  }

  async saveScene() {
    // Without a worker, what it sent last is what there is to save.
    const text = await this.#solver.request({ type: 'scene' }).catch(() => this.#solver.sceneText);
    if (text === null) this.#alerts.error('There is no scene to save.');
    else this.#save(`${this.#name}.shapeup.json`, text, 'application/json');
  }

  /**
   * @param {string} name
   * @param {string} text
   * @param {string} type
   */
  #save(name, text, type) {
    const address = URL.createObjectURL(new Blob([text], { type }));
    element('a', { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
    this.#store.set({ status: `Saved ${name}` });
  }
}
