/**
 * Files in and out: open, the examples, save and export. Tells `opened` after each model that it has
 * opened.
 */

import { count, ended, groupDigits, length } from '../ui/format.js';
import { exampleFile, listOfExamples } from '../solver/examples.js';
import { removeFirstPicture } from '../viewport/placeholder/placeholder-scene.js';
import { Emitter } from '../solver/emitter.js';
import { messageOf } from '../solver/messages.js';
import { isReadable, mainOf } from '../solver/opened-files.js';
import { saveFile } from '../ui/save-file.js';
import { rememberedFrame } from './units-prompt.js';

/** @typedef {import("../solver/messages.js").NamedBytes} NamedBytes */
/** @typedef {import("../solver/examples.js").Example} Example */

/**
 * Where a model comes from.
 * @typedef {object} Origin
 * @property {boolean} [first] it is what the page opens with, solved
 * @property {Example} [example] whose mesh it has
 * @property {string} [work] the name under which it is kept in this browser, see `recent-documents.js`
 * @property {string} [title] of the work
 * @property {string} [text] of its scene as it is kept
 * @property {import("../solver/messages.js").Saved} [saved] beside its scene
 * @property {boolean} [asItCame] its vertices are not welded
 * @property {Before | null} [before] what was open before, which Undo opens again
 */
/** @typedef {{ given: NamedBytes[], origin: Origin }} Before */

const IS_RHINO = /\.3dm$/i;

/** @extends {Emitter<{ opened: void }>} */
export class Files extends Emitter {
  /** Where the model that is open comes from. @type {Origin} */
  origin = {};
  /** The text of its scene when it was opened; null when it is work that goes on. @type {string | null} */
  original = null;
  /** Settles when what somebody chose last is open, or refused; null while nothing is on its way. @type {Promise<unknown> | null} */
  coming = null;
  /** @type {Promise<Example[]> | null} */
  #examples = null;
  #store;
  #solver;
  #alerts;
  #actions;
  /** What was opened last. @type {NamedBytes[]} */
  #given = [];
  /** Base name for what is saved. */
  #name = 'model';

  /**
   * @param {import("../store/state.js").Store} store
   * @param {import("../solver/solver-client.js").SolverClient} solver
   * @param {import("../ui/controls/alerts.js").Alerts} alerts
   * @param {import("../store/actions.js").Actions} actions
   */
  constructor(store, solver, alerts, actions) {
    super();
    this.#store = store;
    this.#solver = solver;
    this.#alerts = alerts;
    this.#actions = actions;
  }

  /**
   * What somebody chose is on its way: whatever is pressed meanwhile is for that.
   * @template T
   * @param {Promise<T>} opening
   * @returns {Promise<T>}
   */
  expect(opening) {
    const coming = opening.finally(() => {
      if (this.coming === coming) this.coming = null;
    });
    this.coming = coming;
    return coming;
  }

  /** Base name for what is saved. */
  get name() {
    return this.#name;
  }

  /**
   * Opens a mesh or a scene, with the mesh that the scene names beside it. When it is refused the
   * old model stays and the alert says why.
   * @param {NamedBytes[]} given
   * @param {Origin} [origin]
   * @param {AbortSignal} [cancelled]
   * @returns {Promise<import("../solver/messages.js").Loaded>} rejects with what the alert says
   */
  async open(given, origin = {}, cancelled) {
    try {
      const files = await Promise.all(given.map((file) => asMesh(file, cancelled)));
      const unreadable = files.find((file) => !isReadable(file));
      if (unreadable) {
        throw new Error(
          `${unreadable.name}: this kind of file cannot be read. Open .obj, .off, .mesh or .3dm for a mesh, .json for a scene.`,
        );
      }
      // A press that waits for the first model has said so.
      const { document, status } = this.#store.get();
      if (document || !status)
        this.#actions.setStatus(`Reading ${files.map((file) => file.name).join(' and ')} …`);
      const main = mainOf(files);
      const { saved, first: solved, asItCame } = origin;
      const frame = rememberedFrame(main.name);
      const loaded = await this.#actions.open({ files, saved, frame, solved, weld: !asItCame });
      this.#name = main.name.replace(/(\.shapeup)?\.[^.]+$/, '');
      this.#given = files;
      this.origin = origin;
      this.original = origin.work ? null : this.#solver.sceneText;
      this.#alerts.clear();
      if (!origin.first) removeFirstPicture();
      this.#actions.describeFile({
        firstExample: Boolean(origin.first),
        fileName: origin.title ?? main.name,
        example: origin.example ?? null,
        isNew: Boolean(origin.before),
        status: `Opened ${main.name}: ${count(loaded.vertices, 'vertex', 'vertices')}, ${count(loaded.faces, 'face')}`,
      });
      if (loaded.welded) this.#reportWelded(loaded.welded, loaded.units);
      this.emit('opened', undefined);
      return loaded;
    } catch (error) {
      this.#actions.setStatus('');
      const { offersToChoose } = await import('./opening/missing-files.js');
      const offers = await offersToChoose(given, this.#actions, this, origin);
      this.#alerts.error(messageOf(error), ...offers);
      throw error;
    }
  }

  /**
   * @param {Example} example
   * @param {boolean} [first] it is what the page opens with, solved
   */
  async openExample(example, first = false) {
    const names = [example.scene, example.mesh];
    const files = await Promise.all(
      names.map(async (name) => ({ name, bytes: await exampleFile(name) })),
    );
    // The first thing that somebody sees of it is what it does.
    if (first) this.#actions.display({ shapes: true });
    await this.open(files, { first, example });
    const { numbers } = this.#store.get();
    const status = first && numbers && ended(true, numbers.iteration);
    this.#actions.setStatus(status || `Opened the example ${example.title}`);
  }

  /** A mesh or a scene of the examples. @param {string} name */
  exampleFile(name) {
    return exampleFile(name);
  }

  /** Opens what was open before a new mesh. */
  async goBack() {
    const { before } = this.origin;
    if (!before) return;
    await this.open(before.given, before.origin).catch(() => {});
    this.#actions.setStatus('Undid: New mesh');
  }

  /** The list of examples. @returns {Promise<Example[]>} */
  examples() {
    // It can be tried again, with a network.
    this.#examples ??= listOfExamples().catch((error) => {
      this.#examples = null;
      throw error;
    });
    return this.#examples;
  }

  /**
   * @param {NonNullable<import("../solver/messages.js").Loaded["welded"]>} welded
   * @param {string} units
   */
  #reportWelded({ before, after, tolerance }, units) {
    const words = `${groupDigits(before)} vertices welded into ${groupDigits(after)}: those within ${length(tolerance, units)} of each other.`;
    const asItCame = () =>
      this.open(this.#given, { ...this.origin, asItCame: true }).catch(() => {});
    this.#alerts.notice(words, { label: 'Undo', action: asItCame });
  }

  /** The current shape in the vertices of the file, before they were welded. */
  async exportAsItCame() {
    if (!(await this.mayExport())) return;
    this.save('.obj', await this.#actions.obj({ asItCame: true }), 'model/obj');
  }

  /** Whether the shape is wanted as it is: asks where a run took the mesh apart. */
  async mayExport() {
    const collapse = this.#store.get().numbers?.collapse;
    return !collapse || (await import('./collapse.js')).askToExport(collapse);
  }

  /** The current shape, with the flat map that is shown, as OBJ. */
  async exportMesh() {
    try {
      if (!(await this.mayExport())) return;
      const uv = this.#store.get().flatMap?.found.uv;
      this.save('.obj', await this.#actions.obj({ uv }), 'model/obj');
    } catch (error) {
      this.#alerts.error(messageOf(error));
    }
  }

  async saveScene() {
    // Without a worker, what it sent last is what there is to save.
    const text = await this.#actions.sceneText().catch(() => this.#solver.sceneText);
    if (text === null) this.#alerts.error('There is no scene to save.');
    else this.save('.shapeup.json', text, 'application/json');
  }

  /**
   * Saves something under the name of the model.
   * @param {string} ending of the file's name
   * @param {BlobPart} content
   * @param {string} type
   */
  save(ending, content, type) {
    const name = `${this.#name}${ending}`;
    saveFile(name, content, type);
    this.#actions.setStatus(`Saved ${name}`);
  }
}

/**
 * A file of Rhino as the mesh that is in it; any other as it is. What reads it comes when it is needed.
 * @param {NamedBytes} file
 * @param {AbortSignal} [cancelled]
 * @returns {Promise<NamedBytes>}
 */
async function asMesh(file, cancelled) {
  if (!IS_RHINO.test(file.name)) return file;
  const { askRhino } = await import('./rhino/rhino-client.js');
  return askRhino({ type: 'read', file }, cancelled);
}
