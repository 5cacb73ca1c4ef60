/**
 * The page's end of the solver's worker: its life, its answers, and the geometry it sends.
 *
 * What is said before the worker is ready is kept and said then. A worker that dies, or falls silent, is
 * replaced and given the last scene that it sent, with the steps of undo.
 */

import { Emitter } from './emitter.js';
import { messageOf } from './messages.js';

/** @typedef {import("./messages.js").FromWorker} FromWorker */
/** @typedef {import("./messages.js").Replies} Replies */
/** @typedef {import("./messages.js").Command} Command */

/**
 * The mesh that is open.
 * @typedef {object} Geometry
 * @property {import("./messages.js").Connectivity} connectivity
 * @property {Float64Array} positions `#V by 3`, the newest; replaced with every frame, so do not keep it
 * @property {Float32Array | null} values of `measure`, `#F`
 * @property {Float32Array | null} corners values of `measure` of the vertices, `#V`, where it has any
 * @property {import("./messages.js").Measure | null} measure
 * @property {Float32Array | null} shapes fitted shapes, eight numbers each
 * @property {import("./messages.js").Projections | null} projections
 */

/**
 * A worker that says nothing is asked to; it lives unless it leaves so many looks without an answer. An
 * iteration may take a while, and so many times as long as the last one did.
 */
const LOOK_EVERY_MS = 1000;
const MOST_MISSED = 3;
const STEPS_MISSED = 10;
/** Looks after which somebody may want to stop what the worker works on. */
const LONG_WORK = 3;

/** What a request was refused for; `path` is the place in the scene that is wrong, if there is one. */
class Refusal extends Error {
  /**
   * @param {string} message
   * @param {string} path
   */
  constructor(message, path) {
    super(message);
    this.path = path;
  }
}

/**
 * What the worker tells, and what is known of the worker itself: it works on something for long (`busy`),
 * it could not be started (`absent`), another one has taken its place (`restarted`).
 * @typedef {Omit<import("./messages.js").WorkerEvents, "reply" | "refused" | "died" | "working" | "pong">
 *   & { busy: { busy: boolean }, absent: { message: string }, restarted: { message: string } }} SolverEvents
 */

/** @extends {Emitter<SolverEvents>} */
export class SolverClient extends Emitter {
  /** @type {Geometry | null} */
  geometry = null;
  /** The text of the scene as the worker last sent it. @type {string | null} */
  sceneText = null;
  /** What belongs to that text. @type {import("./messages.js").Saved} */
  saved = { iteration: 0, history: null, progress: null };

  /** @type {Worker | null} */
  #worker = null;
  #ready = false;
  /** The worker was started to replace one that died, and has not opened its scene yet. */
  #restoring = false;
  /** The model that came last is the one before it, in another worker or with another mesh. */
  #isSame = false;
  #modelName = '';
  /** It has begun with what may take a while. */
  #working = false;
  /** How often it was looked at since then. */
  #busyLooks = 0;
  /** How often it was looked at since it last said something. */
  #missed = 0;
  #stepMs = 0;
  /** @type {[import("./messages.js").ToWorker, Transferable[]][]} */
  #held = [];
  /** @type {Map<number, { resolve: (value: any) => void, reject: (error: Error) => void }>} */
  #waiting = new Map();
  #nextId = 1;
  /** A buffer that the view may still be reading. @type {Float64Array | null} */
  #previous = null;
  /** The last `show`, said again to a new worker. @type {Command | null} */
  #show = null;

  constructor() {
    super();
    this.#start();
    this.#watch();
  }

  /** The model that is open is opened again, in another worker. */
  get restoring() {
    return this.#isSame;
  }

  /**
   * Asks; the promise settles when the answer is here, with everything that it changed.
   * @template {keyof Replies} Type
   * @param {Extract<import("./messages.js").Request, { type: Type }>} request
   * @returns {Promise<Replies[Type]>}
   */
  request(request) {
    const id = this.#nextId++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#post({ ...request, id });
    });
  }

  /**
   * Tells, and expects no answer.
   * @param {Command} command
   * @param {Transferable[]} [transfer]
   */
  send(command, transfer = []) {
    if (command.type === 'show') this.#show = command;
    this.#post(command, transfer);
  }

  /** The newest positions were taken over: the buffer before them can be written again. */
  recycle() {
    if (!this.#previous) return;
    const positions = this.#previous;
    this.#previous = null;
    this.send({ type: 'recycle', positions }, [positions.buffer]);
  }

  /** Whether there is no worker, and there will be none. */
  get isAbsent() {
    return !this.#worker;
  }

  /** Gives up what the worker is at; what was open is open again. */
  abandon() {
    this.#died('it was cancelled', true);
  }

  #start() {
    const worker = new Worker(new URL('../worker/solver-worker.js', import.meta.url), {
      type: 'module',
      name: 'solver',
    });
    this.#worker = worker;
    this.#ready = false;
    worker.onmessage = (event) => this.#receive(event.data);
    worker.onerror = (event) => {
      event.preventDefault();
      const message = event.message?.replace(/^Uncaught /, '');
      this.#died(message || 'its worker could not be fetched');
    };
  }

  /** Replaces a worker that neither works on something nor answers. */
  #watch() {
    let last = performance.now();
    setInterval(() => {
      const now = performance.now();
      // A page that slept, in the background or with its computer, may not have heard an answer.
      const slept = now - last > 2 * LOOK_EVERY_MS;
      last = now;
      if (slept || !this.#ready) return;
      if (this.#working) return this.#setBusy(this.#busyLooks + 1);
      this.#missed += 1;
      const most = Math.max(MOST_MISSED, (STEPS_MISSED * this.#stepMs) / LOOK_EVERY_MS);
      if (this.#missed > most) this.#died('it did not answer');
      else this.#post({ type: 'ping' });
    }, LOOK_EVERY_MS);
  }

  /** Tells `busy` when work gets long, and when it has ended. @param {number} looks */
  #setBusy(looks) {
    const before = this.#busyLooks;
    this.#busyLooks = looks;
    const busy = looks >= LONG_WORK;
    if (busy === before >= LONG_WORK) return;
    this.emit('busy', { busy });
  }

  /**
   * @param {import("./messages.js").ToWorker} message
   * @param {Transferable[]} [transfer]
   */
  #post(message, transfer = []) {
    if (!this.#worker) {
      if ('id' in message)
        this.#answer(message.id, null, new Error('the solver has stopped: reload the page'));
    } else if (this.#ready) {
      this.#worker.postMessage(message, transfer);
    } else {
      this.#held.push([message, transfer]);
    }
  }

  /** @param {FromWorker} message */
  #receive(message) {
    this.#missed = 0;
    this.#working = message.type === 'working';
    if (!this.#working) this.#setBusy(0);
    switch (message.type) {
      case 'working':
      case 'pong':
        return;
      case 'ready': {
        this.#ready = true;
        const held = this.#held;
        this.#held = [];
        for (const [early, transfer] of held) this.#post(early, transfer);
        break;
      }
      case 'model':
        // What is restored is still the model of its file.
        this.#isSame = this.#restoring || !message.loaded.name;
        if (!this.#isSame) this.#modelName = message.loaded.name;
        message.loaded.name = this.#modelName;
        this.#previous = null;
        this.geometry = {
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
        this.saved = { iteration: message.iteration, history: message.history, progress: null };
        break;
      case 'progress':
        this.saved = { ...this.saved, progress: message.bytes };
        break;
      case 'frame': {
        const { geometry } = this;
        if (!geometry || geometry.positions.length !== message.positions.length) return;
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
      case 'died':
        return this.#died(message.message);
    }
    this.emit(message.type, message);
  }

  /**
   * @param {number} id
   * @param {unknown} value
   * @param {Error | null} error
   */
  #answer(id, value, error) {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (error) waiting?.reject(error);
    else waiting?.resolve(value);
  }

  /**
   * @param {string} reason
   * @param {boolean} [wanted] it needs no words
   */
  async #died(reason, wanted = false) {
    const lastScene = this.sceneText;
    const again = this.#restoring;
    const atStart = !this.#ready;
    this.#worker?.terminate();
    this.#worker = null;
    this.#ready = this.#working = false;
    this.#missed = 0;
    this.#setBusy(0);
    this.#held = [];
    for (const id of [...this.#waiting.keys()])
      this.#answer(id, null, new Error(`the solver stopped (${reason})`));
    this.emit('activity', { type: 'activity', running: false, converged: false });

    if (atStart && !lastScene && !wanted) {
      const message = `The solver could not be started (${reason}). Check the network, then reload the page.`;
      return this.emit('absent', { message });
    }
    if ((atStart || again) && !wanted) {
      const what = again ? 'stopped again on the same model' : 'could not be started';
      return this.#notice(
        `The solver ${what} (${reason}). Reload the page; the last scene can still be saved.`,
      );
    }
    this.#start();
    if (this.#show) this.send(this.#show);
    const notice = (/** @type {string} */ text) => wanted || this.#notice(text);
    if (!lastScene) return void notice(`The solver stopped (${reason}) and was restarted.`);
    this.#restoring = true;
    const { saved } = this;
    try {
      const bytes = new TextEncoder().encode(lastScene);
      const files = [{ name: 'restored.shapeup.json', bytes }];
      const { undoLost } = await this.request({ type: 'open', files, saved });
      const back = `your model is back as it was at iteration ${this.saved.iteration}`;
      const but = undoLost ? `, but its undo history is lost: ${undoLost}.` : '.';
      notice(`The solver stopped (${reason}) and was restarted; ${back}${but}`);
    } catch (error) {
      if (this.#worker)
        this.#notice(
          `The solver was restarted, but could not take up the scene: ${messageOf(error)}`,
        );
    } finally {
      this.#restoring = false;
    }
  }

  /** @param {string} message */
  #notice(message) {
    this.emit('restarted', { message });
  }
}
