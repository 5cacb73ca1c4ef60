/**
 * State of the page, in one place; panels subscribe to the parts they show. Geometry is not part of
 * it (it would be copied and compared needlessly); see `solver-client.js`.
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
 * @property {import("../solver/messages.js").Operation[]} operations selection operations
 * @property {import("../solver/messages.js").SettingInfo[]} settings settings of a scene
 * @property {Loaded | null} model
 * @property {number} size diagonal of the bounding box of the mesh as it was opened, in its unit
 * @property {string} fileName name of the file, also of resumed work
 * @property {boolean} firstExample whether the model is the page's first one
 * @property {import("../solver/examples.js").Example | null} example whose mesh is open, if any
 * @property {SceneDocument | null} document
 * @property {Numbers | null} numbers
 * @property {boolean} running Run was pressed and the iteration has not converged
 * @property {boolean} refining "Refine and solve" is running, level by level
 * @property {boolean} converged
 * @property {boolean} halfway the local step is done, the global step is next
 * @property {"drag" | "select"} tool
 * @property {"box" | "lasso" | "paint"} shape of a drag with the Select tool
 * @property {boolean} through whether a drag also selects hidden elements
 * @property {number} brush radius, CSS pixels
 * @property {Mode} mode what a click selects
 * @property {Selection} selection
 * @property {number[]} dragged handles under the pointer
 * @property {{ by: number[], targets: Float64Array } | null} moved how far they are dragged, in units
 *   of the mesh, and where to, `#dragged by 3`
 * @property {string | undefined} gizmoPart axis or plane of the gizmo under the pointer
 * @property {number | undefined} pointedAt handle under the pointer
 * @property {number} dragMs time from the last pointer move to new positions
 * @property {Tint | null} tint members of the constraint under the pointer
 * @property {import("../solver/messages.js").RowColours | null} rowColours colours of constraint rows
 * @property {"model" | "inspector"} tab the visible panel if there is room for only one
 * @property {Measure | null} measure by which the faces are coloured
 * @property {boolean} measureChosen whether the user chose it since the model was opened
 * @property {[number, number]} range range of the colours, in the unit of the measure
 * @property {OwnRange} ownRange the parts of the range that the user chose
 * @property {import("../ui/plot/histogram.js").Spread | null} spread distribution of face values
 * @property {number | null} tolerance tolerance of lengths, in the unit of the mesh
 * @property {Record<Measure, number | null>} tolerances of the other measures, in their units
 * @property {{ edges: boolean, vertices: boolean, shapes: boolean, outlines: boolean, arrows: boolean,
 *   ghost: boolean, ground: boolean, bands: boolean, full: boolean, log: boolean, gizmo: boolean,
 *   timings: boolean, map: "viridis" | "diverging" | "grey" }} display `map` applies if all values are coloured
 * @property {number[] | null} camera in the format of `View.camera`; if anything other than the
 *   viewport sets it, the camera moves there
 * @property {boolean} parallel projection, instead of perspective
 * @property {Section | null} section section plane through the model
 * @property {{ name: string, camera: number[], parallel: boolean }[]} views saved views
 * @property {number[] | null} tape chosen ends of the measuring tape, while that tool is active
 * @property {import("./view-modes.js").FlatMap | null} flatMap shown beside the model
 * @property {import("./view-modes.js").Split | null} split two pictures in place of one
 * @property {import("../solver/messages.js").BuildReport | null} build null without fabrication panel
 * @property {HeldOriginal | null} heldOriginal shown instead of the current shape, on request
 * @property {boolean} advanced whether all controls are shown, not only the essential ones
 * @property {boolean} dark
 * @property {"webgpu" | "webgl2" | "none" | "starting"} renderer
 * @property {boolean} isNew the model is a new mesh that replaced another model
 * @property {string} saved state of the autosave, as text
 * @property {string} status last event, as text
 */

/**
 * User-chosen ends of the colour range and of the legend's axis; null if automatic.
 * @typedef {{ low: number | null, high: number | null, top: number | null }} OwnRange
 */
/**
 * A section plane across an axis of the file (0 to 2), at a fraction from 0 to 1 of the model's
 * extent. The part before it along the axis is kept, or the part after it if `turned`.
 * @typedef {{ axis: number, at: number, turned: boolean }} Section
 */
/** @typedef {"vertices" | "edges" | "faces"} Mode */
/**
 * Edges by their index in `Connectivity.edges`.
 * @typedef {Record<Mode, ReadonlySet<number>>} Selection
 */
/** @typedef {{ vertices: Uint32Array, faces: Uint32Array, colour: [number, number, number] }} Tint */
/**
 * The original shape, `#V by 3`, and its values of the measure, `#F`, if there is one.
 * @typedef {{ positions: Float64Array, values: Float32Array | null }} HeldOriginal
 */

/**
 * @typedef {object} Store
 * @property {() => Readonly<State>} get
 * @property {(keyof State)[]} steady keys on which commands may depend
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

/** Keys that change with every frame; no command depends on them. @type {(keyof State)[]} */
const LIVE = ['numbers', 'moved', 'pointedAt', 'dragMs', 'spread', 'camera'];

/** Whether the view can draw. @param {Pick<State, "renderer">} state */
export const isDrawn = ({ renderer }) => renderer === 'webgpu' || renderer === 'webgl2';

/**
 * Whether a constraint must be met, exactly or within a distance.
 * @param {import("../solver/messages.js").ConstraintRow} row
 */
export const isHard = ({ enabled, require }) => enabled && require !== 'soft';

/**
 * Returns the handles, with the current targets of dragged ones.
 * @param {Readonly<State>} state
 * @returns {import("../solver/messages.js").Handle[]}
 */
export function handlesNow({ document, dragged, moved }) {
  const handles = document?.handles ?? [];
  if (!moved) return handles;
  const offsets = new Map(dragged.map((vertex, i) => [vertex, 3 * i]));
  return handles.map((handle) => {
    const at = offsets.get(handle.vertex);
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

  /** Calls a listener and reports its error. @param {(state: Readonly<State>) => void} listener */
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
