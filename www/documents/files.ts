/** File input and output: open, examples, save, export. Emits `opened` after each opened model. */

import { count, groupDigits, length } from '../ui/format.ts';
import { listOfExamples, type Example } from '../solver/examples.ts';
import { removeFirstPicture } from '../viewport/first-picture.ts';
import { Emitter } from '../solver/emitter.ts';
import { messageOf } from '../solver/errors.ts';
import type { NamedBytes, Saved, Loaded } from '../solver/types.ts';
import { isReadable, mainOf } from '../solver/opened-files.ts';
import { oneAtATime } from '../ui/once.ts';
import { saveFile } from '../ui/save-file.ts';
import { rememberedFrame } from './units-prompt.ts';
import type { Store } from '../store/state.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Alerts } from '../ui/controls/alerts.ts';
import type { Actions } from '../store/actions.ts';
export type { Example } from '../solver/examples.ts';

/** Source of a model. */
export interface Origin {
  /** the model is the page's first one, already solved */
  first?: boolean;
  /** whose mesh the model has */
  example?: Example;
  /** id of the saved work, see `recent-documents.ts` */
  work?: string;
  /** title of the work */
  title?: string;
  /** saved text of its scene */
  text?: string;
  /** text of its scene when it was opened first, if it is reopened */
  original?: string | null;
  /** its saved history and progress */
  saved?: Saved;
  /** do not weld the vertices */
  unwelded?: boolean;
  /** the previously open model, which Undo opens again */
  before?: Before | null;
}
type Before = { given: NamedBytes[]; origin: Origin };

const IS_RHINO = /\.3dm$/i;

export class Files extends Emitter<{ opened: void }> {
  /** Source of the current model. */
  origin: Origin = {};
  /** Text of its scene when opened; null for resumed work. */
  original: string | null = null;
  /** Settles when the file chosen last is opened or refused; null when nothing is being opened. */
  coming: Promise<unknown> | null = null;
  #examples: Promise<Example[]> | null = null;
  #store;
  #solver;
  #alerts;
  #actions;
  /** The files opened last. */
  #given: NamedBytes[] = [];
  /** Base name of saved files. */
  #name = 'model';

  constructor(store: Store, solver: SolverClient, alerts: Alerts, actions: Actions) {
    super();
    this.#store = store;
    this.#solver = solver;
    this.#alerts = alerts;
    this.#actions = actions;
  }

  /** Registers a pending opening: commands given meanwhile apply to the model being opened. */
  trackOpening<T>(opening: Promise<T>): Promise<T> {
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
   * @returns rejects with the error of the alert
   */
  async open(given: NamedBytes[], origin: Origin = {}, cancelled?: AbortSignal): Promise<Loaded> {
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
      const offers = await import('./opening/missing-files.ts').then(
        (it) => it.offersToChoose(given, this.#actions, this, origin),
        () => [],
      );
      this.#alerts.error(messageOf(error), ...offers);
      throw error;
    }
  }

  /** @param first the example is the page's first model, already solved */
  async openExample(example: Example, first: boolean = false) {
    const names = [example.scene, example.mesh];
    const files = await Promise.all(
      names.map(async (name) => ({ name, bytes: await this.exampleFile(name) })),
    );
    // The first view shows the fitted shapes.
    if (first) this.#actions.display({ shapes: true });
    await this.open(files, { first, example });
    const { numbers } = this.#store.get();
    const status = first && numbers?.ended.converged;
    this.#actions.setStatus(status || `Opened the example ${example.title}`);
  }

  /** Returns a mesh or a scene of the examples. */
  exampleFile(name: string) {
    return this.#actions.ask.exampleFile(name);
  }

  /** Reopens the model that was open before a new mesh. */
  async goBack() {
    const { before } = this.origin;
    if (!before) return;
    await this.open(before.given, before.origin).catch(() => {});
    this.#actions.setStatus('Undid: New mesh');
  }

  examples(): Promise<Example[]> {
    // Allows another attempt when the network is back.
    this.#examples ??= listOfExamples().catch((error) => {
      this.#examples = null;
      throw error;
    });
    return this.#examples;
  }

  #reportWelded({ before, after, tolerance }: NonNullable<Loaded['welded']>, units: string) {
    const words = `Welded ${groupDigits(before)} vertices into ${groupDigits(after)} (distance up to ${length(tolerance, units)}).`;
    const openUnwelded = () =>
      this.open(this.#given, { ...this.origin, unwelded: true }).catch(() => {});
    this.#alerts.notice(words, { label: 'Undo', action: openUnwelded });
  }

  /** Exports the current shape with the file's original vertices, before welding. */
  async exportUnwelded() {
    if (!(await this.mayExport())) return;
    this.save('.obj', await this.#actions.ask.objUnwelded(), 'model/obj');
  }

  /** Asks for confirmation if a run has collapsed the mesh; true if the export may go on. */
  async mayExport() {
    const collapse = this.#store.get().numbers?.collapse;
    return !collapse || Boolean(await askToExport(collapse));
  }

  /** Exports the current shape as OBJ, with the displayed flat map. */
  async exportMesh() {
    try {
      if (!(await this.mayExport())) return;
      const uv = this.#store.get().flatMap?.found.uv;
      const { ask } = this.#actions;
      const text = await (uv ? ask.objWithUv(uv) : ask.obj());
      this.save('.obj', text, 'model/obj');
    } catch (error) {
      this.#alerts.error(messageOf(error));
    }
  }

  async saveScene() {
    // Without a worker, save the text received last.
    const text = await this.#actions.ask.scene().catch(() => this.#solver.sceneText);
    if (text === null) this.#alerts.error('There is no scene to save.');
    else this.save('.shapeup.json', text, 'application/json');
  }

  /**
   * Saves a file under the base name of the model.
   * @param ending suffix of the file name
   */
  save(ending: string, content: BlobPart, type: string) {
    const name = `${this.#name}${ending}`;
    saveFile(name, content, type);
    this.#actions.setStatus(`Saved ${name}`);
  }
}

/** Asks whether to export a shape that has collapsed. */
const askToExport = oneAtATime((collapse: string) =>
  import('./collapse.ts').then((it) => it.askToExport(collapse)),
);

/**
 * Converts a Rhino file to OBJ, with a converter loaded on demand; returns other files unchanged.
 */
async function asMesh(file: NamedBytes, cancelled?: AbortSignal): Promise<NamedBytes> {
  if (!IS_RHINO.test(file.name)) return file;
  const { askRhino } = await import('./rhino/rhino-client.ts');
  return askRhino({ type: 'read', file }, cancelled);
}
