/** File input and output: open, examples, save. Emits `opened` after each opened model. */

import { Emitter } from '../solver/emitter.ts';
import { Cancelled, messageOf } from '../solver/errors.ts';
import { listOfExamples, type Example } from '../solver/examples.ts';
import { isReadable, mainOf } from '../solver/opened-files.ts';
import { count, groupDigits, length } from '../ui/words.ts';
import { once } from '../ui/once.ts';
import { saveFile } from '../ui/output.ts';
import { removeFirstPicture } from '../viewport/placeholder.ts';
import { linkToExample } from '../solver/examples.ts';
import { offersToChoose } from './missing-files.ts';
import { Openings, type Opening } from './openings.ts';
import { askRhino } from './rhino/rhino-client.ts';
import type { FromRhino } from './rhino/rhino-in.ts';
import { digestOf, rememberedFrame } from './known-frames.ts';
import { restoreView, viewOf, type SavedView } from '../viewport/saved-view.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Document as SceneDocument } from '../pkg/engine/shape_up.js';
import type { NamedBytes, Saved, Opened } from '../solver/types.ts';
import type { Actions } from '../store/actions.ts';
import { STARTS_LATER } from '../store/perform.ts';
import { untilChanged } from '../store/until-changed.ts';
import type { Store } from '../store/state.ts';
import type { Alerts } from '../ui/controls/alerts.tsx';
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
  /** its scene is not that of the example: a link or a saved work has another one */
  edited?: boolean;
  /** digest of the file that it was opened from, unless it has been changed since */
  file?: string | null;
  /** the user has changed more than how far it is solved, perhaps back again */
  changed?: boolean;
  /** its saved history and progress */
  saved?: Saved;
  /** take what is hidden in a Rhino file */
  hidden?: boolean;
  /** do not weld the vertices */
  unwelded?: boolean;
  /** fragment of the address at which it was opened, with its # */
  link?: string;
  /** camera, measure and open tab at which it was left */
  view?: SavedView | null;
  /** it is only tried: the work before stays that of the tab, also after a reload */
  trial?: boolean;
  /** the model that this one has replaced, as a new mesh does, which Undo opens again */
  before?: Reopenable | null;
  /** the model that Undo has replaced, which Redo opens again */
  after?: Reopenable | null;
  /** the replacing, as a step of Undo in words */
  step?: string;
}
/** Files that may have more faces than this computer stays interactive with. */
export interface Large {
  /** that many */
  most: Promise<number>;
  /** asks whether to open so many all the same; rejects if not */
  ask: (faces: number) => Promise<void>;
  /** called when the solver begins or ends to work for it: a cancelled opening ends that work */
  atWork: (now: boolean) => void;
  /** aborted when the opening is cancelled */
  cancelled: AbortSignal;
}
/** An open model, to be opened again as it was left. */
type Reopenable = { given: NamedBytes[]; origin: Origin };

const IS_RHINO = /\.3dm$/i;

export class Files extends Emitter<{ opened: void }> {
  /** Returns the list of examples. */
  readonly examples = once(listOfExamples);
  /** Source of the current model. */
  origin: Origin = {};
  /** Text of its scene when opened first; that of resumed work as it was saved. */
  original: string | null = null;
  /**
   * All openings of models. Run, Step and Undo given meanwhile apply to the model that is coming; edits of
   * the one before are dropped.
   */
  readonly openings = new Openings(() => this.#alerts.clear());
  #store;
  #solver;
  #alerts;
  #actions;
  /** Text of the scene when it was opened last. */
  #openedText: string | null = null;
  /** The files opened last. */
  #given: NamedBytes[] = [];
  #digest: string | null = null;
  /** Base name of saved files. */
  #name = 'model';
  #replaced = new AbortController();

  constructor(store: Store, solver: SolverClient, alerts: Alerts, actions: Actions) {
    super();
    this.#store = store;
    this.#solver = solver;
    this.#alerts = alerts;
    this.#actions = actions;
    solver.on('document', ({ document }) => this.#forgetUndone(document));
    solver.on('model', () => {
      if (solver.restoring) return;
      this.#replaced.abort(new Cancelled());
      this.#replaced = new AbortController();
    });
  }

  /** Aborted when another model is shown than now. */
  get replaced() {
    return this.#replaced.signal;
  }

  get name() {
    return this.#name;
  }

  /** Makes the address that of the open model: a reload would otherwise open another one. */
  nameInAddress() {
    const { hash, pathname, search } = location;
    const { link = '' } = this.origin;
    if (hash !== link) history.replaceState(null, '', pathname + search + link);
  }

  /** Waits for what is being opened, and says so. */
  async untilOpen() {
    const { coming } = this.openings;
    if (coming) this.#actions.setStatus(STARTS_LATER);
    await coming;
  }

  /** The digest of the main one of the files opened last. */
  get digest() {
    return this.#digest;
  }

  /**
   * Opens a mesh, or a scene together with the mesh file that it names. If a file is refused, the
   * current model stays and an alert gives the reason.
   * @param how.opening that it is part of, if it is not one of its own
   * @param how.large given for files that may have too many faces
   * @returns null if a later opening has taken its place; rejects with the error of the alert
   */
  open(
    given: NamedBytes[],
    origin: Origin = {},
    { opening, large }: { opening?: Opening; large?: Large } = {},
  ): Promise<Opened | null> {
    if (opening) return this.#open(given, origin, opening, large);
    return this.openings.begin((own) => this.#open(given, origin, own, large));
  }

  async #open(
    given: NamedBytes[],
    origin: Origin,
    opening: Opening,
    { cancelled, ...large }: Partial<Large> = {},
  ): Promise<Opened | null> {
    try {
      const hidden = origin.hidden ?? false;
      const files = await Promise.all(given.map((file) => asMesh(file, hidden, cancelled)));
      const unreadable = files.find((file) => !isReadable(file));
      if (unreadable) {
        throw new Error(
          `${unreadable.name}: this kind of file cannot be read. Open .obj, .off, .mesh, .ply, .stl or .3dm for a mesh, .json for a scene.`,
        );
      }
      const main = mainOf(files);
      const digest = await digestOf(main.bytes);
      const most = await large.most;
      // Nothing is waited for between this and the opening: a later one could come first.
      if (!(await opening.isWanted())) return null;
      cancelled?.throwIfAborted();
      // The first view shows the fitted shapes.
      if (origin.first) this.#actions.display({ shapes: true });
      // Keep the status of a button press that waits for the first model.
      const { document, status } = this.#store.get();
      if (document || !status)
        this.#actions.setStatus(`Reading ${files.map((file) => file.name).join(' and ')} …`);
      const { saved, first: solved, unwelded } = origin;
      const frame = rememberedFrame(digest);
      const how = { files, saved, frame, solved, weld: !unwelded };
      const open = (most?: number) => {
        large.atWork?.(true);
        const opened = this.#solver.open({ ...how, most }, cancelled);
        return opened.finally(() => large.atWork?.(false));
      };
      let loaded = await open(most);
      while (typeof loaded === 'number') {
        if (large.ask) await opening.asks(large.ask(loaded));
        if (!(await opening.isWanted())) return null;
        cancelled?.throwIfAborted();
        loaded = await open();
      }
      opening.opened();
      this.#name = main.name.replace(/(\.shapeup)?\.[^.]+$/, '');
      this.#given = files;
      this.#openedText = this.#solver.sceneText;
      this.#digest = digest;
      const { view, ...rest } = origin;
      if (view) restoreView(view, this.#store, this.#actions);
      this.origin = { ...(!origin.work && { file: digest }), ...rest };
      this.original = origin.original ?? origin.text ?? this.#solver.sceneText;
      this.nameInAddress();
      if (!origin.first) removeFirstPicture();
      // What only the first view was to show.
      if (!origin.first && this.#store.get().firstExample) this.#actions.display({ shapes: false });
      this.#actions.look({
        firstExample: Boolean(origin.first),
        fileName: origin.title ?? main.name,
        example: origin.example ?? null,
        undoReplacing: (origin.before && origin.step) || '',
        redoReplacing: origin.after?.origin.step ?? '',
        nothingOpen: false,
        status: `Opened ${main.name}: ${count(loaded.vertices, 'vertex', 'vertices')}, ${count(loaded.faces, 'face')}`,
      });
      if (loaded.welded) this.#reportWelded(loaded.welded, loaded.units);
      this.#reportLeftOut(files, given);
      this.emit('opened', undefined);
      return loaded;
    } catch (error) {
      const isCancelled = error instanceof Cancelled;
      const ask = () => offersToChoose(given, this.#actions, this, origin);
      const offers = isCancelled ? [] : await ask();
      // The question may have waited for the opening of another model.
      if (!(await opening.isWanted())) return null;
      this.#actions.setStatus(isCancelled ? 'Cancelled' : '');
      if (!isCancelled) this.#alerts.error(messageOf(error), ...offers);
      throw error;
    }
  }

  /**
   * Opens an example.
   * @param how.first it is the page's first model, already solved
   * @param how.link fragment of the address that names it; the first model has none
   * @param how.opening that it is part of, if it is not one of its own
   * @returns null if a later opening has taken its place
   */
  async openExample(
    example: Example,
    {
      first = false,
      link = first ? undefined : linkToExample(example.id),
      opening,
    }: { first?: boolean; link?: string; opening?: Opening } = {},
  ): Promise<Opened | null> {
    if (!opening)
      return this.openings.begin((own) => this.openExample(example, { first, link, opening: own }));
    const names = [example.scene, example.mesh];
    const files = await Promise.all(
      names.map(async (name) => ({ name, bytes: await this.exampleFile(name) })),
    );
    const loaded = await this.open(files, { first, example, link }, { opening });
    if (!loaded) return null;
    const { numbers } = this.#store.get();
    const status = first && numbers?.ended.converged;
    this.#actions.setStatus(status || `Opened the example ${example.title}`);
    return loaded;
  }

  /** Returns a mesh or a scene of the examples. */
  exampleFile(name: string) {
    return this.#actions.ask.exampleFile(name);
  }

  /**
   * Returns the open model with the edits that were begun before, and with its undo history, which
   * belongs to the solver's last scene text; null without one. A run ends.
   */
  async asItIs(): Promise<Reopenable | null> {
    if (!this.#store.get().document) return null;
    await this.#actions.settled();
    const { text } = await this.#actions.rest();
    const state = this.#store.get();
    const { saved, sceneText } = this.#solver;
    const bytes = new TextEncoder().encode(sceneText ?? text);
    const { origin, original, name } = this;
    const [title, view] = [state.fileName, viewOf(state)];
    return {
      given: [{ name: `${name}.shapeup.json`, bytes }],
      origin: { ...origin, first: false, saved, original, title, view },
    };
  }

  /**
   * Opens another model in place of the open one.
   * @param next may ask for the open one as it is: what is opened meanwhile was begun later, and wins
   * @returns null if it is not open; an alert gives the reason
   */
  #openInstead(next: () => Promise<Reopenable> | Reopenable): Promise<Opened | null> {
    return this.openings.begin(async (opening) => {
      const left = await this.#actions.reportErrors(next());
      // Of a refusal the reason is told where it opens.
      return left ? this.open(left.given, left.origin, { opening }).catch(() => null) : null;
    });
  }

  /** Reopens the model that this one has replaced. */
  async goBack() {
    const { before, step } = this.origin;
    // While a model is being opened, the open one is not left yet.
    if (!before || this.openings.coming) return;
    const { given, origin } = before;
    const left = async () => ({ given, origin: { ...origin, after: await this.asItIs() } });
    if (await this.#openInstead(left)) this.#actions.setStatus(`Undid: ${step}`);
  }

  /** Reopens the model from which Undo went back, unless this one has changed since. */
  async goForward() {
    const { after } = this.origin;
    if (!after || !this.#store.get().redoReplacing || this.openings.coming) return;
    if (await this.#openInstead(() => after))
      this.#actions.setStatus(`Redid: ${after.origin.step}`);
  }

  /** Forgets the model from which Undo went back, once an edit has taken its place: Redo has nothing. */
  #forgetUndone({ redo }: SceneDocument) {
    const { redoReplacing } = this.#store.get();
    if (!redoReplacing || redo || this.#solver.sceneText === this.#openedText) return;
    this.#actions.look({ redoReplacing: '' });
    delete this.origin.after;
  }

  /** Makes the model that was only tried the one of the tab, with an address of its own. */
  keepTrial() {
    this.origin = { ...this.origin, trial: false, link: undefined };
    this.nameInAddress();
    this.emit('opened', undefined);
  }

  #reportWelded({ before, after, tolerance }: NonNullable<Opened['welded']>, units: string) {
    const words = `Joined vertices that lie on each other: ${groupDigits(before)} became ${groupDigits(after)} (up to ${length(tolerance, units)} apart).`;
    const action = () => this.#openOtherwise(this.#given, { unwelded: true }, 'Separate vertices');
    untilChanged(this.#store, this.#alerts.notice(words, { label: 'Undo', action }));
  }

  /** Opens the files of the open model in another way, as a work of its own; Undo goes back. */
  #openOtherwise(given: NamedBytes[], how: Origin, step: string) {
    const { example, edited, title, link, hidden, unwelded } = this.origin;
    void this.#openInstead(async () => {
      const before = await this.asItIs();
      const same = { example, edited, title, link, hidden, unwelded };
      const origin = { ...same, ...how, before, step };
      return { given, origin };
    });
  }

  /**
   * Reports what of Rhino files was left out, in one message.
   * @param given the files themselves
   */
  #reportLeftOut(files: (NamedBytes & Partial<FromRhino>)[], given: NamedBytes[]) {
    const hidden = files.reduce((sum, file) => sum + (file.hidden ?? 0), 0);
    const words = files.flatMap(({ unread }) => unread || []);
    if (hidden > 0) {
      const objects = count(hidden, 'object is', 'objects are');
      words.push(`${objects} hidden or on a layer that is off, and not loaded.`);
    }
    if (words.length === 0) return;
    const action = () => this.#openOtherwise(given, { hidden: true }, 'Load hidden objects');
    const label = hidden === 1 ? 'Load it too' : 'Load them too';
    const withdraw = this.#alerts.notice(
      words.join(' '),
      ...(hidden > 0 ? [{ label, action }] : []),
    );
    if (hidden > 0) untilChanged(this.#store, withdraw);
  }

  async saveScene() {
    await this.save('.shapeup.json', 'application/json', async () => {
      await this.#actions.settled();
      // Without a worker, save the text received last.
      const text = await this.#actions.ask.scene().catch(() => this.#solver.sceneText);
      if (text === null) this.#alerts.error('There is no scene to save.');
      return text;
    });
  }

  /**
   * Saves a file under the base name of the open model, of which it is made.
   * @param ending suffix of the file name
   * @param make returns its content, or null to save nothing; may end when another model is shown
   */
  async save(
    ending: string,
    type: string,
    make: (replaced: AbortSignal) => Promise<BlobPart | null> | BlobPart | null,
  ) {
    const name = `${this.#name}${ending}`;
    const { replaced } = this;
    try {
      const content = await make(replaced);
      replaced.throwIfAborted();
      if (content === null) return;
      saveFile(name, content, type);
      this.#actions.setStatus(`Saved ${name}`);
    } catch (error) {
      if (!replaced.aborted) throw error;
      this.#alerts.notice(`${name} was not saved: another model was opened meanwhile.`);
    }
  }
}

/**
 * Converts a Rhino file to OBJ; returns other files unchanged.
 * @param hidden takes hidden objects too
 */
async function asMesh(
  file: NamedBytes,
  hidden: boolean,
  cancelled?: AbortSignal,
): Promise<NamedBytes | FromRhino> {
  return IS_RHINO.test(file.name) ? askRhino((rhino) => rhino.read(file, hidden), cancelled) : file;
}
