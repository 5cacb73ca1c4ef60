/** File input and output: open, examples, save, export. Emits `opened` after each opened model. */

import { count, ended, groupDigits, length } from '../ui/format.js';
import { listOfExamples } from '../solver/examples.js';
import { removeFirstPicture } from '../viewport/first-picture.js';
import { Emitter } from '../solver/emitter.js';
import { messageOf } from '../solver/messages.js';
import { isReadable, mainOf } from '../solver/opened-files.js';
import { saveFile } from '../ui/save-file.js';
import { rememberedFrame } from './units-prompt.js';

/** @typedef {import("../solver/messages.js").NamedBytes} NamedBytes */
/** @typedef {import("../solver/examples.js").Example} Example */

/**
 * Source of a model.
 * @typedef {object} Origin
 * @property {boolean} [first] the model is the page's first one, already solved
 * @property {Example} [example] whose mesh the model has
 * @property {string} [work] id of the saved work, see `recent-documents.js`
 * @property {string} [title] title of the work
 * @property {string} [text] saved text of its scene
 * @property {string | null} [original] text of its scene when it was opened first, if it is reopened
 * @property {import("../solver/messages.js").Saved} [saved] its saved history and progress
 * @property {boolean} [unwelded] do not weld the vertices
 * @property {Before | null} [before] the previously open model, which Undo opens again
 */
/** @typedef {{ given: NamedBytes[], origin: Origin }} Before */

const IS_RHINO = /\.3dm$/i;

/** @extends {Emitter<{ opened: void }>} */
export class Files extends Emitter {
  /** Source of the current model. @type {Origin} */
  origin = {};
  /** Text of its scene when opened; null for resumed work. @type {string | null} */
  original = null;
  /**
   * Settles when the file chosen last is opened or refused; null when nothing is being opened.
   * @type {Promise<unknown> | null}
   */
  coming = null;
  /** @type {Promise<Example[]> | null} */
  #examples = null;
  #store;
  #solver;
  #alerts;
  #actions;
  /** The files opened last. @type {NamedBytes[]} */
  #given = [];
  /** Base name of saved files. */
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
   * Registers a pending opening: commands given meanwhile apply to the model being opened.
   * @template T
   * @param {Promise<T>} opening
   * @returns {Promise<T>}
   */
  trackOpening(opening) {
    const coming = opening.finally(() => {
      if (this.coming === coming) this.coming = null;
    });
    this.coming = coming;
    return coming;
  }

  get name() {
    return this.#name;
  }

  /**
   * Opens a mesh, or a scene together with the mesh file that it names. If a file is refused, the
   * current model stays and an alert gives the reason.
   * @param {NamedBytes[]} given
   * @param {Origin} [origin]
   * @param {AbortSignal} [cancelled]
   * @returns {Promise<import("../solver/messages.js").Loaded>} rejects with the error of the alert
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
      // Keep the status of a button press that waits for the first model.
      const { document, status } = this.#store.get();
      if (document || !status)
        this.#actions.setStatus(`Reading ${files.map((file) => file.name).join(' and ')} …`);
      const main = mainOf(files);
      const { saved, first: solved, unwelded } = origin;
      const frame = rememberedFrame(main.name);
      const loaded = await this.#actions.open({ files, saved, frame, solved, weld: !unwelded });
      this.#name = main.name.replace(/(\.shapeup)?\.[^.]+$/, '');
      this.#given = files;
      this.origin = origin;
      this.original = origin.original ?? (origin.work ? null : this.#solver.sceneText);
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
      // Without the offers the error is still shown.
      const offers = await import('./opening/missing-files.js').then(
        (it) => it.offersToChoose(given, this.#actions, this, origin),
        () => [],
      );
      this.#alerts.error(messageOf(error), ...offers);
      throw error;
    }
  }

  /**
   * @param {Example} example
   * @param {boolean} [first] the example is the page's first model, already solved
   */
  async openExample(example, first = false) {
    const names = [example.scene, example.mesh];
    const files = await Promise.all(
      names.map(async (name) => ({ name, bytes: await this.exampleFile(name) })),
    );
    // The first view shows the fitted shapes.
    if (first) this.#actions.display({ shapes: true });
    await this.open(files, { first, example });
    const { numbers } = this.#store.get();
    const status = first && numbers && ended(true, numbers.iteration);
    this.#actions.setStatus(status || `Opened the example ${example.title}`);
  }

  /** Returns a mesh or a scene of the examples. @param {string} name */
  exampleFile(name) {
    return this.#actions.exampleFile(name);
  }

  /** Reopens the model that was open before a new mesh. */
  async goBack() {
    const { before } = this.origin;
    if (!before) return;
    await this.open(before.given, before.origin).catch(() => {});
    this.#actions.setStatus('Undid: New mesh');
  }

  /** @returns {Promise<Example[]>} */
  examples() {
    // Allows another attempt when the network is back.
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
    const words = `Welded ${groupDigits(before)} vertices into ${groupDigits(after)} (distance up to ${length(tolerance, units)}).`;
    const openUnwelded = () =>
      this.open(this.#given, { ...this.origin, unwelded: true }).catch(() => {});
    this.#alerts.notice(words, { label: 'Undo', action: openUnwelded });
  }

  /** Exports the current shape with the file's original vertices, before welding. */
  async exportUnwelded() {
    if (!(await this.mayExport())) return;
    this.save('.obj', await this.#actions.obj({ unwelded: true }), 'model/obj');
  }

  /** Asks for confirmation if a run has collapsed the mesh; true if the export may go on. */
  async mayExport() {
    const collapse = this.#store.get().numbers?.collapse;
    return !collapse || (await import('./collapse.js')).askToExport(collapse);
  }

  /** Exports the current shape as OBJ, with the displayed flat map. */
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
    // Without a worker, save the text received last.
    const text = await this.#actions.sceneText().catch(() => this.#solver.sceneText);
    if (text === null) this.#alerts.error('There is no scene to save.');
    else this.save('.shapeup.json', text, 'application/json');
  }

  /**
   * Saves a file under the base name of the model.
   * @param {string} ending suffix of the file name
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
 * Converts a Rhino file to OBJ, with a converter loaded on demand; returns other files unchanged.
 * @param {NamedBytes} file
 * @param {AbortSignal} [cancelled]
 * @returns {Promise<NamedBytes>}
 */
async function asMesh(file, cancelled) {
  if (!IS_RHINO.test(file.name)) return file;
  const { askRhino } = await import('./rhino/rhino-client.js');
  return askRhino({ type: 'read', file }, cancelled);
}
