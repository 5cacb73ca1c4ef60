/**
 * Iterates the solver in short slices and keeps what must be consistent between messages: whether it
 * runs, what is dragged, and what the page has to be told of it.
 */

import { SLICE_MS, messageOf } from '../solver/messages.js';
import { Frames } from './frames.js';
import { isTrap } from './wasm-errors.js';

/** @typedef {import("../solver/messages.js").FromWorker} FromWorker */
/** @typedef {import("../solver/messages.js").Drag} Drag */
/** @typedef {import("../solver/messages.js").Loaded} Loaded */

/** While it iterates, frames take at most this part of the time, but where a drag waits for its answer. */
const FRAME_PART = 0.25;
/**
 * A run or a drag says at least so often how far it has come, so that little is lost when the page or the
 * worker dies; telling takes at most so large a part of the time.
 */
const PROGRESS_EVERY_MS = 800;
const PROGRESS_PART = 0.05;

export class Scheduler {
  frames;
  #solver;
  #post;
  #died;
  #isLoaded = false;
  /** Run was pressed, and the iteration has not converged since. */
  #isRunning = false;
  /** The run goes on whatever becomes of the shape. */
  #goesOn = false;
  #isDragging = false;
  /** Before that time no frame is sent while it iterates. */
  #nextFrame = 0;
  /** Nothing would change by iterating on; a moved handle or an edit ends it. */
  #isSettled = false;
  /** The newest move of a drag that is not applied yet. @type {Drag | null} */
  #move = null;
  /** The move that the next frame answers, and when it came. @type {{ time: number, came: number } | null} */
  #answering = null;
  /** Until the next word of a run or a drag; 0 while none is due. */
  #progressTimer = 0;
  #progressEvery = PROGRESS_EVERY_MS;
  /** Whether it runs has changed; told after the frame that belongs to it. */
  #activityDue = false;
  #sliceQueued = false;
  /** The next slice has new work to do: it may have to factor the system first. */
  #sliceIsNew = false;
  #yielding = new MessageChannel();

  /**
   * @param {import("../pkg/solver/shape_up.js").Solver} solver
   * @param {(message: FromWorker, transfer?: Transferable[]) => void} post
   * @param {(thrown: unknown) => void} died the wasm machine has trapped
   */
  constructor(solver, post, died) {
    this.#solver = solver;
    this.#post = post;
    this.#died = died;
    this.frames = new Frames(solver, post);
    this.#yielding.port1.onmessage = () => this.#slice();
  }

  get isLoaded() {
    return this.#isLoaded;
  }

  get isIterating() {
    return this.#isLoaded && (this.#isRunning || this.#isDragging) && !this.#isSettled;
  }

  /** Another mesh takes the place of the one that is open. */
  close() {
    if (this.#isRunning) this.#endRun();
  }

  /** Another mesh is open. @param {boolean} solved iterates until nothing changes */
  begin(solved) {
    this.#isLoaded = true;
    this.#isSettled = this.#isDragging = false;
    this.#move = this.#answering = null;
    if (solved) this.#iterate();
  }

  /** @param {boolean} [goOn] whatever becomes of the shape */
  run(goOn = false) {
    if (!this.#isLoaded || this.#isRunning) return;
    this.#post({ type: 'working' });
    this.#solver.beginRun();
    this.#goesOn = goOn;
    if (goOn) this.#solver.goOn();
    this.#isRunning = true;
    this.#isSettled = false;
    this.#sliceIsNew = true;
    this.#sendActivity();
    this.#queueSlice();
  }

  pause() {
    if (!this.#isRunning) return;
    this.#post({ type: 'working' });
    this.#endRun();
    this.changed();
  }

  /** Iterates once. @returns {boolean} whether it has converged */
  step() {
    this.#isSettled = this.#solver.singleStep();
    this.#activityDue = true;
    this.changed();
    return this.#isSettled;
  }

  /** @returns {import("../solver/messages.js").Half} */
  halfStep() {
    const done = this.#solver.halfStep();
    if (done.half === 'global') {
      this.#isSettled = done.converged;
      this.#activityDue = true;
      this.changed();
    } else {
      this.frames.due = true;
      this.sendFrame();
    }
    return done;
  }

  /**
   * Does an edit, outside of the run's own step of undo, and tells the page.
   * @template T
   * @param {() => T} edit
   * @returns {T}
   */
  betweenRuns(edit) {
    if (this.#isRunning) this.#solver.endRun();
    let result;
    try {
      result = edit();
    } finally {
      if (this.#isRunning) this.#solver.beginRun();
    }
    this.#isSettled = false;
    this.#activityDue = true;
    this.changed();
    this.#sliceIsNew = true;
    if (this.#isRunning) this.#queueSlice();
    return result;
  }

  /** Asks something of the panels, and runs. @param {() => void} ask */
  runFor(ask) {
    ask();
    this.#isRunning = true;
    this.#goesOn = this.#isSettled = false;
    this.#activityDue = true;
    this.changed();
    this.#sliceIsNew = true;
    this.#queueSlice();
  }

  /** @param {Drag} message */
  drag(message) {
    const { vertices, targets, phase, time } = message;
    if (phase === 'start' || phase === 'make') {
      const isNew = phase === 'make';
      if (isNew) this.#post({ type: 'working' });
      if (this.#isRunning) this.#solver.endRun();
      this.#solver.drag(vertices, targets, phase);
      this.#isDragging = true;
      this.#activityDue = true;
      // What is saved is the scene before the drag, until that has ended.
      if (isNew) this.#sendDocument();
    } else if (!this.#isDragging) {
      return;
    } else if (phase === 'move') {
      this.#move = message;
      if (time !== undefined) this.#answering = { time, came: performance.now() };
    } else {
      this.#post({ type: 'working' });
      this.#move = this.#answering = null;
      this.#isDragging = false;
      this.#solver.drag(vertices, targets, phase);
      if (this.#isRunning) this.#solver.beginRun();
      // What has to be met is met again where it ends.
      this.#isRunning = this.#solver.isRunning();
      this.#activityDue = true;
      this.changed();
    }
    this.#isSettled = false;
    if (phase !== 'move') this.#sliceIsNew = true;
    this.#queueSlice();
  }

  /** After an edit, a load, the end of a run or a drag: everything the page keeps is renewed. */
  changed() {
    // Refining, and its undo, put another mesh in the place of the one that is open.
    const loaded = this.#solver.remeshed();
    if (loaded) this.sendModel(/** @type {Loaded} */ (loaded));
    // Whoever sees the document, and with it the mesh, can have the scene.
    this.#sendScene();
    this.#sendDocument();
    this.frames.due = true;
    this.sendFrame();
  }

  /** The page is given the mesh that is open, and with the next frame whether it runs. @param {Loaded} loaded */
  sendModel(loaded) {
    const solver = this.#solver;
    this.#activityDue = true;
    const connectivity = {
      faceOffsets: solver.faceOffsets(),
      faceIndices: solver.faceIndices(),
      curveOffsets: solver.curveOffsets(),
      curveIndices: solver.curveIndices(),
      edges: solver.edges(),
    };
    const positions = this.frames.renew(loaded.vertices);
    const arrays = [positions, ...Object.values(connectivity)];
    this.#post(
      { type: 'model', loaded, connectivity, positions },
      arrays.map(({ buffer }) => buffer),
    );
  }

  /**
   * Sends the state of the iteration, if the page has not seen it. That a run has ended is told after its
   * last frame, so that whoever waits for the end sees the end.
   */
  sendFrame() {
    const answers = () => {
      if (!this.#answering || this.#move) return null;
      const { time, came } = this.#answering;
      this.#answering = null;
      return /** @type {[number, number]} */ ([time, performance.now() - came]);
    };
    const begun = performance.now();
    if (this.isIterating && !this.#answering && begun < this.#nextFrame) return;
    if (!this.frames.send(answers, this.isIterating)) return;
    const ended = performance.now();
    this.#nextFrame = ended + (ended - begun) * (1 / FRAME_PART - 1);
    if (this.#activityDue) this.#sendActivity();
  }

  /**
   * Runs what no request is waiting for. An ordinary error stops the run and is told; a trap of the
   * wasm machine leaves the solver unusable.
   * @param {() => void} action
   */
  guard(action) {
    try {
      action();
    } catch (thrown) {
      if (isTrap(thrown)) return this.#died(thrown);
      this.#isRunning = this.#isDragging = false;
      this.#isSettled = true;
      this.#post({ type: 'trouble', message: messageOf(thrown) });
      this.#post({ type: 'activity', running: false, converged: false });
    }
  }

  /** The solver cannot be used any more. */
  stop() {
    this.#isRunning = this.#isDragging = this.#isLoaded = false;
  }

  /** Iterates until nothing would change, as a run of its own. */
  #iterate() {
    this.#solver.beginRun();
    try {
      do this.#isSettled = this.#solver.step();
      while (!this.#isSettled);
    } finally {
      this.#solver.endRun();
    }
  }

  /** Closes the run's step of undo. */
  #endRun() {
    this.#isRunning = false;
    this.#solver.endRun();
    this.#activityDue = true;
  }

  #queueSlice() {
    if (this.#sliceQueued) return;
    this.#sliceQueued = true;
    this.#yielding.port2.postMessage(null);
  }

  /** Iterates for a slice, sends what there is to see, and comes back for more. */
  #slice() {
    this.#sliceQueued = false;
    const isNew = this.#sliceIsNew;
    this.#sliceIsNew = false;
    if (isNew) this.#post({ type: 'working' });
    this.guard(() => this.#iterateForSlice());
    if (isNew) this.#post({ type: 'pong' });
    if (this.isIterating) this.#queueSlice();
  }

  #iterateForSlice() {
    /** @type {string | undefined} */
    let collapse;
    if (this.#move) {
      this.#solver.drag(this.#move.vertices, this.#move.targets, 'move');
      this.#move = null;
      this.#isSettled = false;
    }
    // Who drags waits for the answer.
    const until = performance.now() + (this.#answering ? SLICE_MS / 2 : SLICE_MS);
    while (this.isIterating && performance.now() < until) {
      this.#isSettled = this.#solver.step();
      this.frames.due = true;
    }
    if (this.#isSettled && this.#isRunning && !this.#isDragging) {
      this.#endRun();
      this.changed();
      if (!this.#goesOn) collapse = this.#solver.collapse();
    } else if (this.frames.due) {
      this.#progressTimer ||= setTimeout(() => this.#sendProgress(), this.#progressEvery);
    }
    this.sendFrame();
    if (collapse) this.#post({ type: 'collapsed', collapse });
  }

  #sendDocument() {
    this.#post({ type: 'document', document: this.#solver.document() });
  }

  #sendScene() {
    clearTimeout(this.#progressTimer);
    this.#progressTimer = 0;
    const history = this.#solver.savedHistory();
    const [text, iteration] = [this.#solver.scene(), this.#solver.iteration()];
    this.#post({ type: 'scene', text, history, iteration }, [history.buffer]);
  }

  /** How far a run or a drag has come since the scene that was sent last. */
  #sendProgress() {
    this.#progressTimer = 0;
    if (!this.#isLoaded || !(this.#isRunning || this.#isDragging)) return;
    this.guard(() => {
      const begun = performance.now();
      const bytes = this.#solver.savedProgress();
      const took = performance.now() - begun;
      this.#progressEvery = Math.max(PROGRESS_EVERY_MS, took / PROGRESS_PART);
      this.#post({ type: 'progress', bytes, iteration: this.#solver.iteration() }, [bytes.buffer]);
    });
  }

  #sendActivity() {
    this.#activityDue = false;
    const converged = this.#isSettled && !this.#solver.collapse();
    this.#post({ type: 'activity', running: this.#isRunning, converged });
  }
}
