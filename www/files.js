/** Files in and out: open, drop, the examples, save and export. */

import { count } from './format.js';
import { element } from './dom.js';
import { removeFirstPicture } from './first-picture.js';
import { messageOf } from './messages.js';

/** @typedef {import("./messages.js").NamedBytes} NamedBytes */
/** @typedef {{ id: string, title: string, summary: string, scene: string, mesh: string }} Example */

const READABLE = /\.(obj|off|mesh|json)$/i;
const IS_SCENE = /\.json$/i;
const EXAMPLES = new URL(/* @vite-ignore */ 'examples/', document.baseURI);

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
      this.#store.set({
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
   * @param {boolean} [first] it is what the page opens with
   */
  async openExample(example, first = false) {
    const names = [example.scene, example.mesh];
    const files = await Promise.all(
      names.map(async (name) => ({ name, bytes: await fetched(name) })),
    );
    await this.open(files, first);
    this.#store.set({ status: first ? '' : `Opened the example ${example.title}` });
  }

  /**
   * Opens the first example and fills the menu with all of them.
   * @param {HTMLElement} menu
   */
  async offerExamples(menu) {
    /** @type {Example[]} */
    const examples = JSON.parse(new TextDecoder().decode(await fetched('index.json')));
    menu.replaceChildren(
      ...examples.map((example) =>
        element(
          'button',
          {
            type: 'button',
            role: 'menuitem',
            onclick: () => {
              menu.hidePopover();
              this.openExample(example).catch((error) => this.#alerts.error(messageOf(error)));
            },
          },
          element(
            'span',
            { class: 'entry' },
            element('strong', {}, example.title),
            element('span', {}, example.summary),
          ),
        ),
      ),
    );
    await this.openExample(examples[0], true);
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

  /** The current shape, with the flat map that is shown, as the solver's host writes it everywhere. */
  async exportMesh() {
    try {
      const text = await this.#solver.request({
        type: 'obj',
        uv: this.#store.get().flatMap?.found.uv,
      });
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

/**
 * @param {string} name of a file among the examples
 * @returns {Promise<Uint8Array>}
 */
async function fetched(name) {
  const response = await fetch(new URL(name, EXAMPLES));
  if (!response.ok)
    throw new Error(`The example file ${name} could not be fetched (${response.status}).`);
  return new Uint8Array(await response.arrayBuffer());
}
