/**
 * What the page knows, in one place: panels subscribe to the parts they show. Geometry is not in
 * here (it would be copied and compared for nothing); see `solver-client.js`.
 */

/** @typedef {import("../solver/messages.js").Loaded} Loaded */
/** @typedef {import("../solver/messages.js").SceneDocument} SceneDocument */
/** @typedef {import("../solver/messages.js").Numbers} Numbers */
/** @typedef {import("../solver/messages.js").Measure} Measure */

/**
 * @typedef {object} State
 * @property {import("../solver/messages.js").KindInfo[]} kinds
 * @property {import("../solver/messages.js").ElementInfo[]} elements
 * @property {import("../solver/messages.js").FaceMeasure[]} measures
 * @property {import("../solver/messages.js").Operation[]} operations ways to select
 * @property {import("../solver/messages.js").SettingInfo[]} settings of a scene
 * @property {Loaded | null} model
 * @property {number} size diagonal of the bounding box of the mesh as it was opened, in its unit
 * @property {string} fileName what was opened, also when it is work of last time that goes on
 * @property {boolean} firstExample the model is the one that the page opens with
 * @property {import("../solver/examples.js").Example | null} example whose mesh is open, if it is that of one
 * @property {SceneDocument | null} document
 * @property {Numbers | null} numbers
 * @property {boolean} running Run was pressed and the iteration has not converged
 * @property {boolean} refining Refine and solve is at work, level by level
 * @property {boolean} converged
 * @property {boolean} halfway the local step is done, the global step is next
 * @property {"drag" | "select"} tool
 * @property {"box" | "lasso" | "paint"} shape of a drag with the Select tool
 * @property {boolean} through a drag also selects what the surface hides
 * @property {number} brush radius, CSS pixels
 * @property {Mode} mode what a click selects
 * @property {Selection} selection
 * @property {number[]} dragged handles under the pointer
 * @property {{ by: number[], targets: Float64Array } | null} moved how far they are dragged, in units
 *   of the mesh, and where to, `#dragged by 3`
 * @property {string | undefined} gizmoPart axis or plane of the gizmo under the pointer
 * @property {number | undefined} pointedAt handle under the pointer
 * @property {number} dragMs from the pointer to new positions, of the last move
 * @property {Tint | null} tint members of the constraint that is pointed at
 * @property {import("../solver/messages.js").RowColours | null} rowColours of what constraints act on
 * @property {"model" | "inspector"} tab the panel that is shown where there is room for one
 * @property {Measure | null} measure what the faces are coloured by
 * @property {boolean} measureChosen somebody chose it since the model was opened
 * @property {[number, number]} range of the colours, in the unit of the measure
 * @property {OwnRange} ownRange what somebody chose of it
 * @property {import("../ui/plot/histogram.js").Spread | null} spread of the values of the faces
 * @property {number | null} tolerance of lengths, in the unit of the mesh
 * @property {Record<Measure, number | null>} tolerances of measures that it does not apply to, in their units
 * @property {{ edges: boolean, vertices: boolean, shapes: boolean, outlines: boolean, arrows: boolean,
 *   ghost: boolean, ground: boolean, bands: boolean, full: boolean, log: boolean, gizmo: boolean,
 *   timings: boolean, map: "viridis" | "diverging" | "grey" }} display `map` is that of all values
 * @property {number[] | null} camera where the view is seen from, as `View.camera` gives it; what somebody else
 *   than the viewport sets here is where the camera goes
 * @property {boolean} parallel projection, instead of perspective
 * @property {Section | null} section where the model is cut open
 * @property {{ name: string, camera: number[], parallel: boolean }[]} views that somebody has kept
 * @property {number[] | null} tape the ends of the measuring tape that are chosen, while there is one
 * @property {import("./view-modes.js").FlatMap | null} flatMap what is shown beside the model
 * @property {import("./view-modes.js").Split | null} split two pictures in place of one
 * @property {import("../solver/messages.js").BuildReport | null} build what the panel of parts shows; null while it is closed
 * @property {HeldOriginal | null} heldOriginal shown in place of the current shape while somebody holds
 * @property {boolean} advanced every control is shown, not the essentials alone
 * @property {boolean} dark
 * @property {"webgpu" | "webgl2" | "none" | "starting"} renderer
 * @property {boolean} isNew the model is a new mesh, and something was open before it
 * @property {string} saved what became of the autosave, in words
 * @property {string} status what happened last, in words
 */

/**
 * The ends of the range of the colours and of the axis of the legend, where somebody chose them; null
 * where they follow from the values.
 * @typedef {{ low: number | null, high: number | null, top: number | null }} OwnRange
 */
/**
 * A plane across an axis of the file (0 to 2), a part of the way through the model from 0 to 1. What comes
 * before it along the axis is kept, or what comes after it when it is turned.
 * @typedef {{ axis: number, at: number, turned: boolean }} Section
 */
/** @typedef {"vertices" | "edges" | "faces"} Mode */
/** Edges by their places in `Connectivity.edges`. @typedef {Record<Mode, ReadonlySet<number>>} Selection */
/** @typedef {{ vertices: Uint32Array, faces: Uint32Array, colour: [number, number, number] }} Tint */
/**
 * The shape that was opened, `#V by 3`, and its values of the measure, `#F`, where there is one.
 * @typedef {{ positions: Float64Array, values: Float32Array | null }} HeldOriginal
 */

/**
 * @typedef {object} Store
 * @property {() => Readonly<State>} get
 * @property {(keyof State)[]} steady what commands may depend on
 * @property {(patch: Partial<State>) => void} set
 * @property {(keys: (keyof State)[], listener: (state: Readonly<State>) => void) => void} subscribe
 *   calls the listener now, and after every task in which one of the keys changed
 */

/** @type {State} */
const INITIAL = {
  kinds: [],
  elements: [],
  measures: [],
  operations: [],
  settings: [],
  model: null,
  size: 0,
  fileName: '',
  firstExample: false,
  example: null,
  document: null,
  numbers: null,
  running: false,
  refining: false,
  converged: false,
  halfway: false,
  tool: 'drag',
  shape: 'box',
  through: false,
  brush: 24,
  mode: 'vertices',
  selection: { vertices: new Set(), edges: new Set(), faces: new Set() },
  dragged: [],
  moved: null,
  gizmoPart: undefined,
  pointedAt: undefined,
  dragMs: 0,
  tint: null,
  rowColours: null,
  tab: 'model',
  measure: null,
  measureChosen: false,
  range: [0, 0],
  ownRange: { low: null, high: null, top: null },
  spread: null,
  tolerance: null,
  tolerances: {},
  display: {
    edges: true,
    vertices: false,
    shapes: false,
    outlines: false,
    arrows: false,
    ghost: false,
    ground: false,
    bands: false,
    full: false,
    log: false,
    gizmo: true,
    timings: false,
    map: 'viridis',
  },
  camera: null,
  parallel: false,
  section: null,
  views: [],
  tape: null,
  flatMap: null,
  split: null,
  heldOriginal: null,
  build: null,
  advanced: false,
  dark: false,
  renderer: 'starting',
  isNew: false,
  saved: '',
  status: '',
};

/** What changes with every frame of a run or a drag. No command depends on it. @type {(keyof State)[]} */
const LIVE = ['numbers', 'moved', 'pointedAt', 'dragMs', 'spread', 'camera'];

/** Whether there is a picture. @param {Pick<State, "renderer">} state */
export const isDrawn = ({ renderer }) => renderer === 'webgpu' || renderer === 'webgl2';

/**
 * The handles, those that are dragged where they are dragged to.
 * @param {Readonly<State>} state
 * @returns {import("../solver/messages.js").Handle[]}
 */
export function handlesNow({ document, dragged, moved }) {
  const handles = document?.handles ?? [];
  if (!moved) return handles;
  const places = new Map(dragged.map((vertex, i) => [vertex, 3 * i]));
  return handles.map((handle) => {
    const at = places.get(handle.vertex);
    if (at === undefined) return handle;
    const [x, y, z] = moved.targets.subarray(at, at + 3);
    return { ...handle, target: [x, y, z] };
  });
}

/** @returns {Store} */
export function createStore() {
  let state = INITIAL;
  /** @type {{ keys: (keyof State)[], listener: (state: Readonly<State>) => void }[]} */
  const subscriptions = [];
  /** @type {Set<keyof State>} */
  let changed = new Set();

  function notify() {
    const keys = changed;
    changed = new Set();
    for (const { keys: wanted, listener } of subscriptions) {
      if (wanted.some((key) => keys.has(key))) notifyListener(listener);
    }
  }

  /** One that throws is no harm to the others. @param {(state: Readonly<State>) => void} listener */
  function notifyListener(listener) {
    try {
      listener(state);
    } catch (error) {
      reportError(error);
    }
  }

  return {
    get: () => state,
    steady: /** @type {(keyof State)[]} */ (Object.keys(INITIAL)).filter(
      (key) => !LIVE.includes(key),
    ),
    set(patch) {
      const keys = /** @type {(keyof State)[]} */ (Object.keys(patch)).filter(
        (key) => patch[key] !== state[key],
      );
      if (keys.length === 0) return;
      state = { ...state, ...patch };
      if (changed.size === 0) queueMicrotask(notify);
      keys.forEach((key) => changed.add(key));
    },
    subscribe(keys, listener) {
      subscriptions.push({ keys, listener });
      notifyListener(listener);
    },
  };
}
