/**
 * The worker: owns the one Solver, iterates it in short slices, and speaks the messages of
 * `messages.js`. It decides nothing that the page should decide; it keeps what must be consistent
 * between messages: whether the solver runs, what is dragged, which buffer is free.
 */

import init, { Solver } from '../pkg/solver/shape_up.js';
import { cancelExperiment, experimentCsv, runExperiment } from './experiment.js';
import { SLICE_MS, messageOf } from '../solver/messages.js';
import { companionOf, mainOf } from '../solver/opened-files.js';
import { findRemedies, stopTrials } from './remedies.js';
import { isTrap } from './wasm-errors.js';
import { disturb, mostFaces, warmUpWhenQuiet } from './warm-up.js';
import { fetchModule } from './fetch-wasm.js';

/** @typedef {import("../solver/messages.js").ToWorker} ToWorker */
/** @typedef {import("../solver/messages.js").FromWorker} FromWorker */

/** What makes it useless to try what would help the shape as it is. @type {Set<ToWorker["type"]>} */
const CHANGES = new Set([
  'run',
  'drag',
  'open',
  'edit',
  'makePanels',
  'undo',
  'redo',
  'step',
  'halfStep',
]);
/**
 * A run or a drag says at least so often how far it has come, so that little is lost when the page or the
 * worker dies; telling takes at most so large a part of the time.
 */
const PROGRESS_EVERY_MS = 800;
const PROGRESS_PART = 0.05;

/** @type {InstanceType<typeof Solver> | null} */
let solver = null;
let loaded = false;
/** Run was pressed, and the iteration has not converged since. */
let running = false;
/** The run goes on whatever becomes of the shape. */
let goesOn = false;
let dragging = false;
/** Nothing would change by iterating on; a moved handle or an edit ends it. */
let settled = false;
/** Something that the page has not seen. */
let unseen = false;
/** The newest move of a drag that is not applied yet. @type {import("../solver/messages.js").Drag | null} */
let move = null;
/** The move that the next frame answers, and when it came. @type {{ time: number, came: number } | null} */
let answering = null;
/** Buffers of positions that are here and free. @type {Float64Array[]} */
let free = [];
let positionsLength = 0;
/** @type {import("../solver/messages.js").Measure | null} */
let measure = null;
let showShapes = false;
let showProjections = false;
let showCorners = false;
/** Until the next word of a run or a drag; 0 while none is due. */
let progressTimer = 0;
let progressEvery = PROGRESS_EVERY_MS;
let sliceQueued = false;
/** The next slice has new work to do: it may have to factor the system first. */
let sliceIsNew = false;
/** Whether it runs has changed; told after the frame that belongs to it. */
let activityDue = false;

const yielding = new MessageChannel();
yielding.port1.onmessage = slice;

/** Messages that came before the solver was there. @type {ToWorker[] | null} */
let early = [];
onmessage = (event) => {
  if (early) early.push(event.data);
  else receive(event.data);
};

try {
  await init({ module_or_path: fetchModule(post) });
  solver = new Solver();
  post({
    type: 'ready',
    kinds: solver.kinds(),
    elements: solver.elements(),
    measures: solver.measures(),
    operations: solver.operations(),
    settings: solver.settings(),
  });
  const held = early ?? [];
  early = null;
  held.forEach(receive);
} catch (thrown) {
  post({ type: 'died', message: messageOf(thrown) });
}

/**
 * @param {FromWorker} message
 * @param {Transferable[]} [transfer]
 */
function post(message, transfer = []) {
  postMessage(message, { transfer });
}

/** The solver, for calls that only happen after `ready`. */
function live() {
  if (!solver) throw new Error('the solver is not there');
  return solver;
}

/** @param {ToWorker} message */
function receive(message) {
  if (!solver) return;
  // Between slices: whoever asks learns that the worker lives.
  if (message.type === 'ping') return post({ type: 'pong' });
  disturb();
  if (CHANGES.has(message.type)) stopTrials();
  if (!('id' in message)) return guard(() => command(message));
  const { id } = message;
  post({ type: 'working' });
  const refuse = (/** @type {unknown} */ thrown) => {
    if (isTrap(thrown)) die(thrown);
    const path = thrown instanceof Error && 'path' in thrown ? String(thrown.path) : '';
    post({ type: 'refused', id, message: messageOf(thrown), path });
  };
  try {
    const value = answer(message);
    if (!(value instanceof Promise)) return post({ type: 'reply', id, value });
    value.then((value) => post({ type: 'reply', id, value }), refuse);
    // It goes on in slices.
    post({ type: 'pong' });
  } catch (thrown) {
    refuse(thrown);
  }
}

/** @param {Exclude<import("../solver/messages.js").Command, { type: "ping" }>} message */
function command(message) {
  switch (message.type) {
    case 'recycle':
      if (message.positions.length === positionsLength && free.length < 2)
        free.push(message.positions);
      warmUpWhenQuiet(iterating);
      return sendFrame();
    case 'show':
      measure = message.measure;
      showShapes = message.shapes;
      showProjections = message.projections;
      showCorners = message.corners;
      unseen = loaded;
      return sendFrame();
    case 'run':
      if (!loaded || running) return;
      post({ type: 'working' });
      live().beginRun();
      goesOn = message.goOn ?? false;
      if (goesOn) live().goOn();
      running = true;
      settled = false;
      sliceIsNew = true;
      sendActivity();
      return queueSlice();
    case 'pause':
      return pause();
    case 'drag':
      return drag(message);
    case 'cancelExperiment':
      return cancelExperiment();
  }
}

/**
 * @param {Extract<ToWorker, { id: number }>} message
 * @returns {unknown}
 */
function answer(message) {
  switch (message.type) {
    case 'open':
      return open(message);
    case 'edit':
      if (message.edit.type === 'reset') pause();
      return betweenRuns(() => live().edit(message.edit), null);
    case 'makePanels':
      return makePanels(message);
    case 'undo':
      pause();
      return betweenRuns(() => live().undo());
    case 'redo':
      pause();
      return betweenRuns(() => live().redo());
    case 'step':
      pause();
      return step();
    case 'halfStep':
      pause();
      return halfStep();
    case 'faceValues':
      if (message.original) return live().originalValues(message.measure);
      return live().faceValues(message.measure);
    case 'cornerValues':
      return live().cornerValues(message.measure);
    case 'originalPositions':
      return live().originalPositions();
    case 'angles':
      return live().angles();
    case 'members':
      return live().members(message.constraint);
    case 'rowColours':
      return live().rowColours();
    case 'previews':
      return live().previews(message.places);
    case 'worst':
      return message.measure
        ? live().worstFaces(message.measure, message.count)
        : live().worstConstraints(message.row ?? 0, message.count);
    case 'flawed':
      return live().flawed(message.flaw);
    case 'verdict':
      return live().verdict(message.tolerance);
    case 'remedies':
      return findRemedies(live());
    case 'mostFaces':
      return mostFaces();
    case 'results':
      return live().results(message.student, message.time);
    case 'select':
      return live().select(message.request);
    case 'scene':
      return live().scene();
    case 'obj':
      if (message.asItCame) return live().objAsItCame();
      return message.uv ? live().objWithUv(message.uv) : live().obj();
    case 'parametrize':
      pause();
      return live().parametrize(message.weights, message.norm);
    case 'table':
      return live().table(message.table);
    case 'trace':
      return live().trace();
    case 'runExperiment':
      return runExperiment(message, post, die);
    case 'experimentCsv':
      return experimentCsv();
  }
}

/** @param {Extract<ToWorker, { type: "open" }>} message */
function open({ files, saved, frame = '', solved, weld }) {
  const main = mainOf(files);
  const companion = companionOf(files, (scene) => live().sceneMeshFile(scene));
  if (running) endRun();
  live().assume(frame);
  live().keepApart(weld === false);
  const about = {
    ...live().load(main.name, main.bytes, companion?.bytes ?? null),
    files: companion ? [main.name, companion.name] : [main.name],
  };
  about.undoLost = saved ? restore(saved) : '';
  loaded = true;
  settled = false;
  dragging = false;
  move = answering = null;
  if (solved) iterate(true);
  positionsLength = about.vertices * 3;
  const positions = new Float64Array(positionsLength);
  live().writePositions(positions);
  free = [new Float64Array(positionsLength)];
  const connectivity = {
    faceOffsets: live().faceOffsets(),
    faceIndices: live().faceIndices(),
    curveOffsets: live().curveOffsets(),
    curveIndices: live().curveIndices(),
    edges: live().edges(),
  };
  post({ type: 'model', loaded: about, connectivity, positions }, [
    positions.buffer,
    ...Object.values(connectivity).map((array) => array.buffer),
  ]);
  activityDue = true;
  changed();
  return about;
}

/**
 * Goes on where the scene that was just opened stood when it was saved.
 * @param {import("../solver/messages.js").Saved} saved
 * @returns {string} why its steps of undo are gone; empty when they are not
 */
function restore({ iteration, history, progress }) {
  live().restoreIteration(iteration);
  try {
    live().restore(history ?? new Uint8Array(0), progress ?? new Uint8Array(0));
    return '';
  } catch (thrown) {
    if (isTrap(thrown)) throw thrown;
    return messageOf(thrown);
  }
}

/**
 * Does an edit, outside of the run's own step of undo, and tells the page.
 * @template T
 * @param {() => T} edit
 * @param {T} [value] answered instead of what the edit returns
 */
function betweenRuns(edit, value) {
  if (running) live().endRun();
  let result;
  try {
    result = edit();
  } finally {
    if (running) live().beginRun();
  }
  settled = false;
  activityDue = true;
  changed();
  sliceIsNew = true;
  if (running) queueSlice();
  return value === undefined ? result : value;
}

/** Asks one shape of all panels, and runs. @param {Extract<ToWorker, { type: "makePanels" }>} message */
function makePanels({ kind, tolerance }) {
  live().makePanels(kind, tolerance);
  running = true;
  goesOn = settled = false;
  activityDue = true;
  changed();
  sliceIsNew = true;
  queueSlice();
  return null;
}

function step() {
  iterate(false);
  activityDue = true;
  changed();
  return settled;
}

/** Iterates once or until nothing would change, as a run of its own. @param {boolean} toTheEnd */
function iterate(toTheEnd) {
  live().beginRun();
  try {
    do settled = live().step();
    while (toTheEnd && !settled);
  } finally {
    live().endRun();
  }
}

function halfStep() {
  const done = live().halfStep();
  if (done.half === 'global') {
    settled = done.converged;
    activityDue = true;
    changed();
  } else {
    unseen = true;
    sendFrame();
  }
  return done;
}

function pause() {
  if (!running) return;
  post({ type: 'working' });
  endRun();
  changed();
}

/** Closes the run's step of undo. */
function endRun() {
  running = false;
  live().endRun();
  activityDue = true;
}

/** @param {import("../solver/messages.js").Drag} message */
function drag(message) {
  const { vertices, targets, phase, time } = message;
  if (phase === 'start' || phase === 'make') {
    const isNew = phase === 'make';
    if (isNew) post({ type: 'working' });
    if (running) live().endRun();
    live().drag(vertices, targets, phase);
    dragging = true;
    activityDue = true;
    // What is saved is the scene before the drag, until that has ended.
    if (isNew) sendDocument();
  } else if (!dragging) {
    return;
  } else if (phase === 'move') {
    move = message;
    if (time !== undefined) answering = { time, came: performance.now() };
  } else {
    post({ type: 'working' });
    move = answering = null;
    dragging = false;
    live().drag(vertices, targets, phase);
    if (running) live().beginRun();
    changed();
  }
  settled = false;
  if (phase !== 'move') sliceIsNew = true;
  queueSlice();
}

/** Iterates for a slice, sends what there is to see, and comes back for more. */
function slice() {
  sliceQueued = false;
  const isNew = sliceIsNew;
  sliceIsNew = false;
  if (isNew) post({ type: 'working' });
  guard(() => {
    /** @type {import("../solver/messages.js").Collapse | null} */
    let collapsed = null;
    if (move) {
      live().drag(move.vertices, move.targets, 'move');
      move = null;
      settled = false;
    }
    // Who drags waits for the answer.
    const until = performance.now() + SLICE_MS / (answering ? 2 : 1);
    while (iterating() && performance.now() < until) {
      settled = live().step();
      unseen = true;
    }
    if (settled && running && !dragging) {
      endRun();
      changed();
      if (!goesOn) collapsed = live().collapse();
    } else if (unseen) {
      progressTimer ||= setTimeout(sendProgress, progressEvery);
    }
    sendFrame();
    if (collapsed) post({ type: 'collapsed', ...collapsed });
  });
  if (isNew) post({ type: 'pong' });
  if (iterating()) queueSlice();
}

function iterating() {
  return loaded && (running || dragging) && !settled;
}

function queueSlice() {
  if (sliceQueued) return;
  sliceQueued = true;
  yielding.port2.postMessage(null);
}

/** After an edit, a load, the end of a run or a drag: everything the page keeps is renewed. */
function changed() {
  sendDocument();
  sendScene();
  unseen = true;
  sendFrame();
}

function sendDocument() {
  post({ type: 'document', document: live().document() });
}

function sendScene() {
  clearTimeout(progressTimer);
  progressTimer = 0;
  const history = live().savedHistory();
  const [text, iteration] = [live().scene(), live().iteration()];
  post({ type: 'scene', text, history, iteration }, [history.buffer]);
}

/** How far a run or a drag has come since the scene that was sent last. */
function sendProgress() {
  progressTimer = 0;
  if (!loaded || !(running || dragging)) return;
  guard(() => {
    const begun = performance.now();
    const bytes = live().savedProgress();
    const took = performance.now() - begun;
    progressEvery = Math.max(PROGRESS_EVERY_MS, took / PROGRESS_PART);
    post({ type: 'progress', bytes, iteration: live().iteration() }, [bytes.buffer]);
  });
}

function sendActivity() {
  activityDue = false;
  post({ type: 'activity', running, converged: settled && !live().collapse() });
}

/**
 * Sends the state of the iteration, if the page has not seen it and a buffer is free. That a run
 * has ended is told after its last frame, so that whoever waits for the end sees the end.
 */
function sendFrame() {
  if (!unseen || free.length === 0) return;
  const positions = /** @type {Float64Array} */ (free.pop());
  live().writePositions(positions);
  const numbers = live().frame();
  const values = measure ? live().faceValues(measure) : null;
  const corners = (measure && showCorners && live().cornerValues(measure)) || null;
  const shapes = showShapes ? live().fitted() : null;
  /** @type {Transferable[]} */
  const transfer = [positions.buffer];
  if (values) transfer.push(values.buffer);
  if (corners) transfer.push(corners.buffer);
  if (shapes) transfer.push(shapes.buffer);
  /** @type {import("../solver/messages.js").Projections | null} */
  const projections = showProjections ? live().projections() : null;
  if (projections) transfer.push(...Object.values(projections).map((array) => array.buffer));
  /** @type {[number, number] | null} */
  const answers = answering && !move ? [answering.time, performance.now() - answering.came] : null;
  if (answers) answering = null;
  post(
    {
      ...{ type: 'frame', numbers, positions },
      ...{ measure, values, corners, shapes, projections, answers },
    },
    transfer,
  );
  unseen = false;
  if (activityDue) sendActivity();
}

/**
 * Runs what no request is waiting for. An ordinary error stops the run and is told; a trap of the
 * wasm machine leaves the solver unusable.
 * @param {() => void} action
 */
function guard(action) {
  try {
    action();
  } catch (thrown) {
    if (isTrap(thrown)) return die(thrown);
    running = false;
    dragging = false;
    settled = true;
    post({ type: 'trouble', message: messageOf(thrown) });
    post({ type: 'activity', running, converged: false });
  }
}

/** @param {unknown} thrown */
function die(thrown) {
  solver = null;
  running = false;
  dragging = false;
  loaded = false;
  post({ type: 'died', message: messageOf(thrown) });
}
