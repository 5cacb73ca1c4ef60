/**
 * Page side of the solver's worker: its lifecycle, answers, and geometry.
 *
 * Messages are queued until the worker is ready. A worker that dies or stops answering is replaced
 * by a new one, which gets the last scene with its undo history.
 */

import { Emitter } from './emitter.ts';
import { Cancelled, messageOf, retryIfCollateral } from './errors.ts';
import type { FromWorker, WorkerEvents } from './events.ts';
import { calling, Waiting, type Call, type Remote, type Told } from './remote.ts';
import type { DrawnProjections } from '../pkg/engine/shape_up.js';
import type { Connectivity, Loaded, Measure, Snapshot, Saved } from './types.ts';
import type { Changes, Commands, Questions } from '../worker/interface.ts';
import type { Opening } from '../worker/open.ts';

/** The current mesh. */
export interface Geometry {
  /**
   * raised with every other mesh and every other shape: what was made for another generation is out
   * of date
   */
  generation: number;
  /** generation of problem and shape in the worker, as of the latest frame */
  solved: number | null;
  connectivity: Connectivity;
  /** latest positions, `#V by 3`; replaced with every frame */
  positions: Float64Array;
  /** of `measure`, `#F` */
  values: Float32Array | null;
  /** values of `measure` at the vertices, `#V`, if it has any */
  corners: Float32Array | null;
  measure: Measure | null;
  /** fitted shapes, eight numbers each */
  shapes: Float64Array | null;
  projections: DrawnProjections | null;
}

/** What the model keeps from its file when its mesh is changed or restored. */
type OfFile = Pick<Loaded, 'name' | 'guessed'> | null;

/**
 * A silent worker gets a ping at each check, and is replaced after `MOST_MISSED` checks without an
 * answer; later if the last iteration took long, as it may take `STEPS_MISSED` times as long.
 */
const CHECK_EVERY_MS = 1000;
const MOST_MISSED = 3;
const STEPS_MISSED = 10;
/** Number of checks after which the user may want to stop the current work. */
const LONG_WORK = 3;

/**
 * Not repeated after cancelled work: undo and redo would take back something else, `open` is repeated
 * by its caller.
 */
const ONCE: ReadonlySet<string> = new Set<keyof Changes>(['undo', 'redo', 'open']);

/** Error of a refused request; `path` is the position of the error in the scene, if any. */
class Refusal extends Error {
  path;

  constructor(message: string, path: string) {
    super(message);
    this.path = path;
  }
}

/**
 * The worker's messages, and events about the worker itself: it has been working for long (`busy`),
 * it could not be started (`absent`), it was replaced (`restarted`).
 */
type SolverEvents = Omit<
  WorkerEvents,
  'reply' | 'refused' | 'outdated' | 'died' | 'working' | 'pong'
> & {
  busy: { busy: boolean };
  absent: { message: string };
  restarted: { message: string };
};

export class SolverClient extends Emitter<SolverEvents> {
  geometry: Geometry | null = null;
  /** Text of the scene as last sent by the worker, and its generation there. */
  sceneText: string | null = null;
  #sceneGeneration: number | null = null;
  /** Data saved with that text. */
  saved: Saved = { iteration: 0, history: null, progress: null };

  /** Numbers of the constraints in the latest document: a new worker goes on with them. */
  #rows: number[] = [];
  #compiled: (module: WebAssembly.Module) => void = () => {};
  /** The engine's module; pending until the worker is ready. */
  readonly module = new Promise<WebAssembly.Module>((resolve) => (this.#compiled = resolve));

  #worker: Worker | null = null;
  #ready = false;
  /** Number in the worker of the mesh that the page shows; 0 if it has none of the page's. */
  #mesh = 0;
  /** The worker replaces one that died, and has not opened its scene yet. */
  #restoring = false;
  /** The latest `model` is the previous model, in a new worker or with another mesh. */
  #isSameModel = false;
  #opened: OfFile = null;
  /** The previous scene, while the next one is being opened. */
  #replaced: { opened: OfFile; text: string | null; saved: Saved } | null = null;
  /** Whether the worker has begun work that may take long. */
  #working = false;
  /** The call that this work is for, unless it is for none, as that of a run. */
  #workingFor: number | undefined;
  /** Number of checks since then. */
  #busyChecks = 0;
  /** Number of checks since its last message. */
  #missed = 0;
  #stepMs = 0;
  #held: [Call, Transferable[]][] = [];
  #waiting = new Waiting();
  /** What was begun and is not done yet: see `begin`. */
  #begun: Set<Promise<unknown>> = new Set();
  /** Generation of the latest geometry. */
  #generation = 0;
  /** A buffer that the view may still be reading. */
  #previous: Float64Array | null = null;
  /** The last `show`, sent again to a new worker. */
  #show: Call | null = null;

  /** Questions and changes: their promises settle after all events that they cause. */
  readonly ask: Remote<Questions> = calling((name, given) => this.#asked(name, given));
  readonly change: Remote<Changes> = calling((name, given) => this.begin(this.#asked(name, given)));
  /** Commands, which have no answer. */
  readonly tell: Told<Commands> = calling((name, given) => {
    const command = { name, given, mesh: this.#mesh };
    if (name === 'show') this.#show = command;
    this.#post(command);
  });

  constructor() {
    super();
    this.#start();
    this.#watch();
  }

  /** Whether the current model is being opened again, in a new worker or with another mesh. */
  get restoring() {
    return this.#isSameModel;
  }

  /** Whether a new worker reopens the mesh that is shown. */
  get reopensSameMesh() {
    return this.#restoring;
  }

  /**
   * Registers something begun by the user that later presses build on: every change is, and so is a
   * selection that the solver finds.
   */
  begin<T>(begun: Promise<T>): Promise<T> {
    const end = () => this.#begun.delete(begun);
    this.#begun.add(begun);
    begun.then(end, end);
    return begun;
  }

  /** Resolves when the page shows all that was begun before, whether done or refused. */
  async settled() {
    await Promise.allSettled(this.#begun);
  }

  /** Returns the previous buffer once the latest positions have been transferred to the view. */
  recycle() {
    if (!this.#previous) return;
    const positions = this.#previous;
    this.#previous = null;
    const call = { name: 'recycle', given: [positions], mesh: this.#mesh };
    this.#post(call, [positions.buffer]);
  }

  /**
   * Returns the model as it was when the worker was last idle, for the second worker; null until the
   * scene of a new model has come.
   */
  copy(): Snapshot | null {
    const { sceneText: text } = this;
    const generation = this.#sceneGeneration;
    return text === null || generation === null ? null : { text, generation };
  }

  /** Whether there is no worker, for good. */
  get isAbsent() {
    return !this.#worker;
  }

  /**
   * Opens files. When `cancelled` is aborted, the current work is abandoned. What waits behind cancelled
   * work is opened after it, unless it has been `cancelled` itself.
   */
  open(given: Opening, cancelled?: AbortSignal) {
    const stop = () => this.abandon();
    cancelled?.addEventListener('abort', stop);
    const ask = () => this.change.open(given);
    const opened = retryIfCollateral(ask, () => cancelled?.throwIfAborted());
    return opened.finally(() => cancelled?.removeEventListener('abort', stop));
  }

  /** Abandons the current work; the previous model is opened again. */
  abandon() {
    void this.#died('it was cancelled', true);
  }

  #start() {
    const worker = new Worker(new URL('../worker/solver-worker.ts', import.meta.url), {
      type: 'module',
      name: 'solver',
    });
    this.#worker = worker;
    this.#ready = false;
    worker.onmessage = (event) => this.#receive(event.data);
    worker.onerror = (event) => {
      event.preventDefault();
      const message = event.message?.replace(/^Uncaught /, '');
      void this.#died(message || 'its worker could not be fetched');
    };
  }

  /** Replaces a worker that neither works nor answers. */
  #watch() {
    let last = performance.now();
    setInterval(() => {
      const now = performance.now();
      // After the page slept (in the background, or with the computer), answers may be pending.
      const slept = now - last > 2 * CHECK_EVERY_MS;
      last = now;
      if (slept || !this.#ready) return;
      if (this.#working) return this.#setBusy(this.#busyChecks + 1);
      this.#missed += 1;
      const most = Math.max(MOST_MISSED, (STEPS_MISSED * this.#stepMs) / CHECK_EVERY_MS);
      if (this.#missed > most) void this.#died('it did not answer');
      else this.#post({ name: 'ping', given: [] });
    }, CHECK_EVERY_MS);
  }

  /** Emits `busy` when work becomes long, and when it has ended. */
  #setBusy(checks: number) {
    const before = this.#busyChecks;
    this.#busyChecks = checks;
    const busy = checks >= LONG_WORK;
    if (busy === before >= LONG_WORK) return;
    this.emit('busy', { busy });
  }

  /** Requests something; what waits behind cancelled work is done after it. */
  #asked(name: string, given: unknown[]) {
    const request = () => this.#request(name, given);
    return ONCE.has(name) ? request() : retryIfCollateral(request);
  }

  #request(name: string, given: unknown[]) {
    const mesh = this.#mesh;
    return this.#waiting.call(name, given, (call) => this.#post({ ...call, mesh }));
  }

  #post(call: Call, transfer: Transferable[] = []) {
    if (!this.#worker) {
      if (call.id !== undefined)
        this.#answer(call.id, null, new Error('the solver has stopped: reload the page'));
    } else if (this.#ready) {
      this.#worker.postMessage(call, transfer);
    } else {
      this.#held.push([call, transfer]);
    }
  }

  #receive(message: FromWorker) {
    this.#missed = 0;
    this.#working = message.type === 'working';
    if (!this.#working) {
      this.#setBusy(0);
      this.#workingFor = undefined;
    }
    switch (message.type) {
      case 'working':
        // Parts of it are announced without the call.
        this.#workingFor ??= message.id;
        return;
      case 'pong':
        return;
      case 'ready': {
        this.#ready = true;
        this.#compiled(message.module);
        const held = this.#held;
        this.#held = [];
        for (const [early, transfer] of held) this.#post(early, transfer);
        break;
      }
      case 'model':
        this.#mesh = message.mesh;
        this.#isSameModel = this.#restoring || !message.loaded.name;
        if (!this.#isSameModel) {
          this.#replaced = { opened: this.#opened, text: this.sceneText, saved: this.saved };
          const { name, guessed } = message.loaded;
          this.#opened = { name, guessed };
        }
        Object.assign(message.loaded, this.#opened);
        this.#sceneGeneration = null;
        this.#previous = null;
        this.geometry = {
          generation: ++this.#generation,
          solved: null,
          connectivity: message.connectivity,
          positions: message.positions,
          values: null,
          corners: null,
          measure: null,
          shapes: null,
          projections: null,
        };
        break;
      case 'scene':
        this.sceneText = message.text;
        this.#sceneGeneration = message.generation;
        this.saved = { iteration: message.iteration, history: message.history, progress: null };
        break;
      case 'document':
        this.#rows = message.document.constraints.map(({ number }) => number);
        break;
      case 'progress':
        this.saved = { ...this.saved, progress: message.bytes };
        break;
      case 'frame': {
        const { geometry } = this;
        if (!geometry || geometry.positions.length !== message.positions.length) return;
        // Frames also come for another measure, or for numbers alone.
        if (message.positions.some((x, i) => x !== geometry.positions[i]))
          geometry.generation = ++this.#generation;
        geometry.solved = message.generation;
        this.#previous = geometry.positions;
        geometry.positions = message.positions;
        geometry.values = message.values;
        geometry.corners = message.corners;
        geometry.measure = message.measure;
        geometry.shapes = message.shapes;
        geometry.projections = message.projections;
        this.#stepMs = message.numbers.stepMs;
        break;
      }
      case 'reply':
        return this.#answer(message.id, message.value, null);
      case 'refused':
        return this.#answer(message.id, null, new Refusal(message.message, message.path));
      case 'outdated':
        return this.#answer(message.id, null, new Cancelled());
      case 'died':
        return this.#died(message.message);
    }
    this.emit(message.type, message);
  }

  #answer(id: number, value: unknown, error: Error | null) {
    if (this.#waiting.settle(id, value, error) === 'open') this.#replaced = null;
  }

  /** @param wanted at the user's request: tell only what is lost */
  async #died(reason: string, wanted: boolean = false) {
    // The first mesh of the next worker will be that of the last scene, which the page may show already.
    this.#mesh = this.#replaced || this.#sceneGeneration === null ? 0 : 1;
    // A scene that has not been opened to the end is not the page's scene.
    if (this.#replaced)
      ({ opened: this.#opened, text: this.sceneText, saved: this.saved } = this.#replaced);
    const lastScene = this.sceneText;
    const wasRestoring = this.#restoring;
    const atStart = !this.#ready;
    const [working, workingFor] = [this.#working, this.#workingFor];
    this.#worker?.terminate();
    this.#worker = null;
    this.#ready = this.#working = false;
    this.#workingFor = undefined;
    this.#missed = 0;
    this.#setBusy(0);
    this.#held = [];
    this.#previous = this.#replaced = null;
    this.#waiting.fail((_, place, id) => {
      // What waited behind the work that the user has cancelled can be asked for again.
      const isDirect = working ? id === workingFor : place === 0;
      return wanted ? new Cancelled(isDirect) : new Error(`the solver stopped (${reason})`);
    });
    this.emit('activity', { type: 'activity', running: false, converged: false });

    if (atStart && !lastScene && !wanted) {
      const message = `The solver could not be started (${reason}). Check the network, then reload the page.`;
      return this.emit('absent', { message });
    }
    if ((atStart || wasRestoring) && !wanted) {
      const what = wasRestoring ? 'stopped again on the same model' : 'could not be started';
      return this.#notice(
        `The solver ${what} (${reason}). Reload the page; the last scene can still be saved.`,
      );
    }
    this.#start();
    if (this.#show) this.#post(this.#show);
    if (!lastScene)
      return void (wanted || this.#notice(`The solver stopped (${reason}) and was restarted.`));
    this.#restoring = true;
    const worker = this.#worker;
    const { saved } = this;
    try {
      const bytes = new TextEncoder().encode(lastScene);
      const files = [{ name: 'restored.shapeup.json', bytes }];
      const opened = await this.change.open({ files, saved, rows: this.#rows });
      const undoLost = typeof opened === 'object' && opened.undoLost;
      const back = `your model is back as it was at iteration ${this.saved.iteration}`;
      const but = undoLost ? `, but its undo history is lost: ${undoLost}.` : '.';
      if (!wanted || undoLost)
        this.#notice(`The solver stopped (${reason}) and was restarted; ${back}${but}`);
    } catch (error) {
      // Not if this worker has been replaced in its turn.
      if (this.#worker === worker)
        this.#notice(
          `The solver was restarted, but could not reopen the scene: ${messageOf(error)}`,
        );
    } finally {
      if (this.#worker === worker) this.#restoring = false;
    }
  }

  #notice(message: string) {
    this.emit('restarted', { message });
  }
}
