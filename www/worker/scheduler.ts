/**
 * Iterates the solver in short slices and keeps the state between messages: whether it runs, what
 * is dragged, and which updates are due for the page.
 */

import { isTrap, messageOf } from '../solver/errors.ts';
import type { FromWorker } from '../solver/events.ts';
import type { Drag } from '../solver/types.ts';
import { Frames } from './frames.ts';
import type {
  Document as SceneDocument,
  FrameNumbers,
  HalfStep,
  Loaded,
  Solver,
} from '../pkg/engine/shape_up.js';

/** Duration of a slice of iterations between messages, in milliseconds. */
export const SLICE_MS = 8;
/** Largest share of the time for frames while iterating, unless a drag waits for its answer. */
const FRAME_SHARE = 0.25;
/**
 * Interval at which a run or a drag sends its progress, so that little is lost if the page or the
 * worker dies, and the largest share of the time that this may take.
 */
const PROGRESS_EVERY_MS = 800;
const PROGRESS_SHARE = 0.05;
type Moved = Pick<Drag, 'vertices' | 'targets'>;
/** Of a drag that ends where it is. */
const NO_MOVE: Moved = { vertices: new Uint32Array(0), targets: new Float64Array(0) };

/**
 * Performs an action, and recovers from an error; not from a trap, after which the solver refuses every
 * call with an error that would hide it.
 */
function orRecover<T>(action: () => T, recover: () => void): T {
  try {
    return action();
  } catch (thrown) {
    if (!isTrap(thrown)) recover();
    throw thrown;
  }
}

export class Scheduler {
  frames;
  /** Number of the first mesh of the open model, and of its current one, among all that were sent. */
  meshes: [number, number] = [0, 0];
  /** The document that was sent last. */
  document: SceneDocument | null = null;
  #solver;
  #post;
  #died;
  #isLoaded = false;
  /** Run was pressed, and the iteration has not converged since. */
  #isRunning = false;
  /** Number of the drag that is under way. */
  #drag: number | null = null;
  /** While iterating, no frame is sent before this time. */
  #nextFrame = 0;
  /** Whether the iteration has converged; a moved handle, or an edit of problem or shape, resets it. */
  #isSettled = false;
  /** The latest move of a drag that is not applied yet. */
  #move: Drag | null = null;
  /** The move that the next frame answers. */
  #answering: { time: number; came: number } | null = null;
  /** Timer of the next progress message; 0 if none is due. */
  #progressTimer: ReturnType<typeof setTimeout> | 0 = 0;
  #progressEvery = PROGRESS_EVERY_MS;
  /** Whether `activity` must be sent, after the frame that belongs to it. */
  #activityDue = false;
  /** How the run or the step that has ended has collapsed the shape, to be told after that. */
  #collapse: string | undefined;
  #sliceQueued = false;
  /** Whether the next slice may have to factor the system first. */
  #sliceIsNew = false;
  /** Whether the page was told in this slice that its work may take long. */
  #isWorking = false;
  #yielding = new MessageChannel();

  /** @param died called when the wasm instance has trapped */
  constructor(
    solver: Solver,
    post: (message: FromWorker, transfer?: Transferable[]) => void,
    died: (thrown: unknown) => void,
  ) {
    this.#solver = solver;
    this.#post = post;
    this.#died = died;
    this.frames = new Frames(solver, post);
    this.#yielding.port1.onmessage = () => this.#slice();
  }

  get isLoaded() {
    return this.#isLoaded;
  }

  /** Whether a run or a drag is under way. */
  get isMoving() {
    return this.#isRunning || this.#drag !== null;
  }

  get isIterating() {
    return this.#isLoaded && this.isMoving && !this.#isSettled;
  }

  /** Replaces the model, after the end of its run; if the other one is refused, it stays. */
  replace<T>(load: () => T): T {
    const wasRunning = this.#isRunning;
    if (wasRunning) this.#endRun();
    // The page does not know yet that the run has ended.
    return orRecover(load, () => wasRunning && this.changed());
  }

  /**
   * Starts with another mesh.
   * @param solved iterate until convergence first
   */
  begin(solved: boolean) {
    this.#isLoaded = true;
    this.#isSettled = false;
    this.#drag = this.#move = this.#answering = null;
    if (solved) this.#iterate();
  }

  run() {
    if (!this.#isLoaded || this.#isRunning) return;
    this.#post({ type: 'working' });
    this.#solver.beginRun();
    this.#isRunning = true;
    this.#isSettled = false;
    this.#sliceIsNew = true;
    // The run is what Undo takes back now.
    this.#sendDocument();
    this.#sendActivity();
    this.#queueSlice();
  }

  pause() {
    if (!this.#isRunning) return;
    this.#post({ type: 'working' });
    this.#endRun();
    this.changed();
  }

  /**
   * Iterates once.
   * @returns the new numbers: their frame waits for a free buffer
   */
  step(): FrameNumbers {
    this.#isSettled = this.#single(() => this.#solver.singleStep());
    this.#activityDue = true;
    this.changed();
    return this.#solver.frame(this.isIterating);
  }

  halfStep(): HalfStep {
    const wasDragging = this.#drag !== null;
    const done = this.#single(() => this.#afterDrag(() => this.#solver.halfStep()));
    if (done.half !== 'local') {
      this.#isSettled = done.half === 'held' || done.converged;
      this.#activityDue = true;
      this.changed();
    } else if (wasDragging) {
      this.#activityDue = true;
      this.changed();
    } else {
      this.frames.due = true;
      this.sendFrame();
    }
    return done;
  }

  /** Performs a single step; a collapse is told when it comes, not after each step from there. */
  #single<T>(step: () => T): T {
    const before = this.#solver.collapse();
    const done = step();
    if (!before) this.#collapse = this.#solver.collapse();
    return done;
  }

  /**
   * Performs an edit as a separate step of undo from the run's, and updates the page.
   * @param settles given for an edit of the shape itself: whether no run could improve the shape of
   *   one that returns true
   */
  betweenRuns<T>(edit: () => T, settles?: boolean): T {
    const before = this.#solver.generation();
    const result = this.#afterDrag(() => this.#duringRun(edit));
    this.#goOn();
    // What leaves problem and shape as they were leaves a converged shape converged.
    const isMade = settles === undefined ? this.#solver.generation() !== before : result === true;
    if (isMade) this.#isSettled = settles === true;
    this.#activityDue = true;
    this.changed();
    this.#sliceIsNew = true;
    if (this.#isRunning) this.#queueSlice();
    return result;
  }

  /** Requests something, and runs. What is refused leaves a run or a drag as it was. */
  runFor(ask: () => void) {
    this.#afterDrag(() => this.#duringRun(ask));
    this.#isRunning = true;
    this.#isSettled = false;
    // At once: a short run ends before its first frame, and nobody would know of it.
    this.#sendActivity();
    this.changed();
    this.#sliceIsNew = true;
    this.#queueSlice();
  }

  /** Performs a phase of a drag; nothing, if that drag was refused or is over. */
  drag(message: Drag) {
    const { id, phase, time } = message;
    const begins = phase === 'start' || phase === 'make';
    if (!begins && id !== this.#drag) return;
    if (begins) {
      if (phase === 'make') this.#post({ type: 'working' });
      if (!this.#beginDrag(message)) return;
      this.#drag = id;
      this.#activityDue = true;
      // Not the scene: the saved one stays that before the drag until the drag ends.
      if (phase === 'make') this.#sendDocument();
    } else if (phase === 'move') {
      this.#move = message;
      if (time !== undefined) this.#answering = { time, came: performance.now() };
    } else {
      this.#post({ type: 'working' });
      this.#endDrag(phase, message);
      this.#activityDue = true;
      this.changed();
    }
    this.#isSettled = false;
    if (phase !== 'move') this.#sliceIsNew = true;
    this.#queueSlice();
  }

  /** Performs what ends a drag, as an edit, which acts on its latest move; if refused, the drag goes on. */
  #afterDrag<T>(action: () => T): T {
    this.#applyMove();
    const result = action();
    // An edit without effect has not ended it in the solver.
    this.#endDrag('end');
    return result;
  }

  /** Ends the drag, if one is under way, and tells the page. */
  #endDrag(phase: 'end' | 'cancel', { vertices, targets }: Moved = NO_MOVE) {
    const id = this.#drag;
    if (id === null) return;
    this.#drag = this.#move = this.#answering = null;
    this.#solver.drag(vertices, targets, phase);
    this.#post({ type: 'dragEnded', id });
    this.#goOn();
    // Hard constraints are met again after the drag.
    this.#isRunning = this.#solver.isRunning();
  }

  /** Applies the latest move. */
  #applyMove() {
    if (!this.#move) return;
    this.#solver.drag(this.#move.vertices, this.#move.targets, 'move');
    this.#move = null;
    this.#isSettled = false;
  }

  /** Returns whether a drag may begin. A refused one is reported, and leaves a run as it was. */
  #beginDrag({ id, vertices, targets, phase }: Drag) {
    try {
      this.#duringRun(() => this.#solver.drag(vertices, targets, phase));
      return true;
    } catch (thrown) {
      if (isTrap(thrown)) throw thrown;
      this.#post({ type: 'trouble', message: messageOf(thrown) });
      this.#post({ type: 'dragEnded', id });
      this.#sendDocument();
      return false;
    }
  }

  /**
   * Performs what may end in the solver a run, or a variation that is shown, also if it is then refused:
   * the run goes on then, and the page gets the shape that there is.
   */
  #duringRun<T>(action: () => T): T {
    const before = this.#solver.generation();
    return orRecover(action, () => {
      this.#goOn();
      if (this.#solver.generation() !== before) this.changed();
    });
  }

  /** Begins the run again, unless the solver has not ended it. */
  #goOn() {
    if (this.#isRunning && !this.#solver.isRunning()) this.#solver.beginRun();
  }

  /** Sends mesh, scene, document and frame after an edit, a load, or the end of a run or a drag. */
  changed() {
    // Refining, and undoing it, replace the mesh.
    const loaded = this.#solver.remeshed();
    // The page keeps the name and the guesses of the file.
    if (loaded) this.sendModel(loaded);
    // The scene comes first, so that it is up to date whenever the page has the document.
    this.sendScene();
    this.#sendDocument();
    this.frames.due = true;
    this.sendFrame();
  }

  /** Sends the current mesh; the next frame is followed by `activity`. */
  sendModel(loaded: Loaded) {
    const mesh = this.meshes[1] + 1;
    // One that was made by a change of the model has no name.
    this.meshes = [loaded.name ? mesh : this.meshes[0], mesh];
    this.#activityDue = true;
    const connectivity = this.#solver.connectivity();
    const positions = this.frames.renew(loaded.vertices);
    const arrays = [positions, ...Object.values(connectivity)];
    this.#post(
      { type: 'model', mesh, loaded, connectivity, positions },
      arrays.map(({ buffer }) => buffer),
    );
  }

  /**
   * Sends the state of the iteration, if it has changed. The end of a run is reported after its
   * last frame, so that the page shows the final state by then.
   */
  sendFrame() {
    const answers = () => {
      if (!this.#answering || this.#move) return null;
      const { time, came } = this.#answering;
      this.#answering = null;
      return [time, performance.now() - came] as [number, number];
    };
    const begun = performance.now();
    if (this.isIterating && !this.#answering && begun < this.#nextFrame) return;
    if (!this.frames.send(answers, this.isIterating)) return;
    const ended = performance.now();
    this.#nextFrame = ended + (ended - begun) * (1 / FRAME_SHARE - 1);
    if (this.#activityDue) this.#sendActivity();
  }

  /**
   * Performs an action that no request waits for. An ordinary error is reported, and ends the run or
   * cancels the drag, in the solver too; a trap leaves the solver unusable.
   */
  guard(action: () => void) {
    try {
      action();
    } catch (thrown) {
      if (isTrap(thrown)) return this.#died(thrown);
      const wasMoving = this.isMoving;
      this.#isRunning = this.#isSettled = false;
      this.#post({ type: 'trouble', message: messageOf(thrown) });
      this.#post({ type: 'activity', running: false, converged: false });
      if (!wasMoving) return;
      this.guard(() => {
        if (this.#drag !== null) this.#endDrag('cancel');
        else if (this.#solver.isRunning()) this.#endRun();
        this.changed();
      });
    }
  }

  /** Stops everything; the solver is unusable. */
  stop() {
    this.#isRunning = this.#isLoaded = false;
    this.#drag = null;
  }

  /** Iterates until convergence, as a run of its own. */
  #iterate() {
    this.#solver.beginRun();
    const end = () => this.#solver.endRun();
    orRecover(() => {
      do this.#isSettled = this.#solver.step();
      while (!this.#isSettled);
    }, end);
    end();
  }

  /** Ends the run and its step of undo. */
  #endRun() {
    this.#isRunning = false;
    this.#activityDue = true;
    this.#collapse = this.#solver.endRun();
  }

  #queueSlice() {
    if (this.#sliceQueued) return;
    this.#sliceQueued = true;
    this.#yielding.port2.postMessage(null);
  }

  /** Iterates for a slice, sends a frame, and queues the next slice. */
  #slice() {
    this.#sliceQueued = false;
    if (this.#sliceIsNew) this.#work();
    this.#sliceIsNew = false;
    this.guard(() => this.#iterateForSlice());
    if (this.#isWorking) this.#post({ type: 'pong' });
    this.#isWorking = false;
    if (this.isIterating) this.#queueSlice();
  }

  /** Tells the page, once per slice, that its work may take long. */
  #work() {
    if (!this.#isWorking) this.#post({ type: 'working' });
    this.#isWorking = true;
  }

  #iterateForSlice() {
    this.#applyMove();
    // Shorter while the user waits for the answer of a drag.
    const until = performance.now() + (this.#answering ? SLICE_MS / 2 : SLICE_MS);
    while (this.isIterating && performance.now() < until) {
      // Factoring all hard constraints takes seconds on a large mesh.
      if (this.#solver.isMeeting()) this.#work();
      this.#isSettled = this.#solver.step();
      this.frames.due = true;
    }
    if (this.#isSettled && this.#isRunning && this.#drag === null) {
      this.#endRun();
      this.changed();
    } else if (this.frames.due) {
      this.#progressTimer ||= setTimeout(() => this.#sendProgress(), this.#progressEvery);
    }
    this.sendFrame();
  }

  #sendDocument() {
    this.document = this.#solver.document();
    this.#post({ type: 'document', document: this.document });
  }

  /** Sends the scene, for autosave and the second worker. */
  sendScene() {
    clearTimeout(this.#progressTimer);
    this.#progressTimer = 0;
    const history = this.#solver.savedHistory();
    const [text, iteration] = [this.#solver.scene(), this.#solver.iteration()];
    const generation = this.#solver.generation();
    this.#post({ type: 'scene', text, generation, history, iteration }, [history.buffer]);
  }

  /** Sends the progress of a run or a drag since the last scene sent. */
  #sendProgress() {
    this.#progressTimer = 0;
    if (!this.#isLoaded || !this.isMoving) return;
    this.guard(() => {
      const begun = performance.now();
      const bytes = this.#solver.savedProgress();
      const took = performance.now() - begun;
      this.#progressEvery = Math.max(PROGRESS_EVERY_MS, took / PROGRESS_SHARE);
      this.#post({ type: 'progress', bytes, iteration: this.#solver.iteration() }, [bytes.buffer]);
    });
  }

  #sendActivity() {
    this.#activityDue = false;
    const isCollapsed = Boolean(this.#solver.collapse());
    const converged = this.#isSettled && !isCollapsed;
    this.#post({ type: 'activity', running: this.#isRunning, converged });
    const collapse = this.#collapse;
    this.#collapse = undefined;
    // It may have been undone, or run again, before the last frame of the run.
    if (collapse && isCollapsed && !this.#isRunning) this.#post({ type: 'collapsed', collapse });
  }
}
