/**
 * State of the page, in one place; panels subscribe to the parts they show. Geometry is not part of
 * it (it would be copied and compared needlessly); see `solver-client.ts`.
 */

import { computed, effect, signal, type ReadonlySignal } from '@preact/signals';
import { NOTHING } from './selection.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type {
  BuildReport,
  ConstraintRow,
  FaceMeasure,
  FewerFlips,
  KindWords,
  ConformalNorm,
  ConformalWeights,
  FrameNumbers,
  Operation,
  FlatMap as Parametrization,
  DrawnRowColours,
  Document as SceneDocument,
  Setting,
  PanelVerdict,
} from '../pkg/engine/shape_up.js';
import type { Loaded, Measure } from '../solver/types.ts';
import type { Example } from '../solver/examples.ts';
import type { Spread } from './colours/spread.ts';

export interface State {
  kinds: KindWords[];
  measures: FaceMeasure[];
  /** selection operations */
  operations: Operation[];
  /** settings of a scene */
  settings: Setting[];
  model: Loaded | null;
  /** name of the file, also of resumed work */
  fileName: string;
  /** whether the model is the page's first one */
  firstExample: boolean;
  /** not even the first example could be opened */
  nothingOpen: boolean;
  /** whose mesh is open, if any */
  example: Example | null;
  document: SceneDocument | null;
  /**
   * that the user has chosen unit or axis: the digest of the file, and which of them were confirmed as
   * they had been guessed
   */
  frameChosen: { digest: string | null; units: boolean; up: boolean } | null;
  /** number of refused edits, after which the controls show the document again */
  refused: number;
  numbers: FrameNumbers | null;
  /** Run was pressed and the iteration has not converged */
  running: boolean;
  /** "Refine and solve" is running, level by level */
  refining: boolean;
  converged: boolean;
  /** the local step is done, the global step is next */
  halfway: boolean;
  tool: 'drag' | 'select';
  /** of a drag with the Select tool */
  shape: 'box' | 'lasso' | 'paint';
  /** whether a drag also selects hidden elements */
  through: boolean;
  /** whether a box or a lasso also selects what it only touches, whichever way it is drawn */
  touching: boolean;
  /** whether what is selected is added, as with Shift */
  adds: boolean;
  /** radius, CSS pixels */
  brush: number;
  /** what a click selects */
  mode: Mode;
  selection: Selection;
  /** handles that are dragged */
  dragged: number[];
  /** how far they are dragged, in units of the mesh, and where to, `#dragged by 3` */
  moved: { by: number[]; targets: Float64Array } | null;
  /** axis or plane of the gizmo under the pointer */
  gizmoPart: string | undefined;
  /** handle under the pointer */
  pointedAt: number | undefined;
  /** time from the last pointer move to new positions */
  dragMs: number;
  /** elements that are marked, each by its cause as long as that lasts */
  tints: Partial<Record<Marking, Tint | null>>;
  /** colours of constraint rows */
  rowColours: DrawnRowColours | null;
  /** the visible step if there is room for only one */
  step: Step;
  /** the steps whose content is in sight */
  openSteps: Step[];
  /** of the window: wide, small (narrow or low), or narrow with a step open over a part of the view */
  room: 'wide' | 'small' | 'sheet';
  /** by which the faces are coloured */
  measure: Measure | null;
  /** whether the user chose it since the model was opened */
  measureChosen: boolean;
  /** range of the colours, in the unit of the measure */
  range: [number, number];
  /** the parts of the range that the user chose */
  ownRange: OwnRange;
  /** largest value of the measure in the latest frame, if one colours the faces */
  greatest: { measure: Measure; value: number } | null;
  /** distribution of face values; null if nothing can draw */
  spread: Spread | null;
  /** the card in the corner of the view, which draws lines on the surface */
  corner: 'curvature' | 'new-panels' | null;
  /** the panel that is docked below the view */
  docked: 'variations' | 'parts' | null;
  /** tolerances of measures that do not have the model's, by id, in their units */
  tolerances: Record<Measure, number | null>;
  /** `map` applies if all values are coloured */
  display: {
    edges: boolean;
    vertices: boolean;
    shapes: boolean;
    outlines: boolean;
    arrows: boolean;
    ghost: boolean;
    ground: boolean;
    bands: boolean;
    full: boolean;
    log: boolean;
    gizmo: boolean;
    timings: boolean;
    legend: boolean;
    map: 'viridis' | 'cividis' | 'turbo' | 'diverging' | 'grey';
  };
  /**
   * in the format of `View.camera`; if anything other than the viewport sets it, the camera moves
   * there
   */
  camera: number[] | null;
  /** whose mouse buttons move the camera */
  mouse: Mouse;
  /** projection, instead of perspective */
  parallel: boolean;
  /** section plane through the model */
  section: Section | null;
  /** saved views */
  views: { name: string; camera: number[]; parallel: boolean }[];
  /** chosen ends of the measuring tape, while that tool is active */
  tape: number[] | null;
  /** shown beside the model */
  flatMap: FlatMap | null;
  /** on the panels, and the generation of the shape that it is on */
  verdict: { shape: number | undefined; report: PanelVerdict } | null;
  /** the last press that made all panels of this mesh one shape */
  press: PanelPress | null;
  /** whether a press shows the fitted shapes or hides them; null if that is as `display` says */
  fitted: boolean | null;
  /** whether the user has closed the card of the panels of this mesh */
  closedCard: boolean;
  /** null without fabrication panel */
  build: BuildReport | null;
  /** why the parts that goals of the lesson bound could not be built; empty if they could */
  goalsRefused: string;
  /** shown instead of the current shape, on request */
  heldOriginal: HeldOriginal | null;
  /** a presentation covers the page */
  presenting: boolean;
  /** id of the plot or table of the analysis */
  plot: string;
  dark: boolean;
  renderer: 'webgpu' | 'webgl2' | 'none' | 'starting';
  /** what has put the model in place of another one, which Undo opens again; empty if nothing has */
  undoReplacing: string;
  /** the same, undone: Redo opens the other one again */
  redoReplacing: string;
  /** state of the autosave, as text */
  saved: string;
  /** last event, as text */
  status: string;
}

/**
 * Content of a surface: the checkerboard of the map, or the colours of the quasi-conformal error.
 */
type Look = 'checks' | 'errors';

export interface FlatMap {
  found: Parametrization;
  /** of the computation */
  weights: ConformalWeights;
  /** of the computation */
  norm: ConformalNorm;
  /** the shape that was flattened, `#V by 3` */
  shape: Float64Array;
  /** settings with fewer flipped triangles; null if not searched */
  fewerFlips: FewerFlips | 'searching' | 'none' | null;
  onModel: Look;
  onMap: Look;
  /** number of squares along the longer side of the map */
  squares: number;
}

export interface PanelPress {
  /** whether the shape still changes */
  isUnderWay: boolean;
  /** of the better choice that was pressed; empty if none was */
  label: string;
  /** generation of the shape that it led to, once it is known */
  shape?: number;
}

/** User-chosen ends of the colour range and of the legend's axis; null if automatic. */
type OwnRange = { low: number | null; high: number | null; top: number | null };
/** Both ends of the range and the end of the axis are automatic. */
export const AUTOMATIC: OwnRange = { low: null, high: null, top: null };
/**
 * A section plane across an axis of the file (0 to 2), at a fraction from 0 to 1 of the model's
 * extent. The part before it along the axis is kept, or the part after it if `turned`.
 */
export type Section = { axis: number; at: number; turned: boolean };
/** The programs whose mouse buttons can be chosen. */
export const MOUSE_SETTINGS = ['rhino', 'web', 'blender'] as const;
export type Mouse = (typeof MOUSE_SETTINGS)[number];
/** The steps of the page, in their order. */
export const STEPS = ['open', 'shape', 'move', 'check', 'build'] as const;
export type Step = (typeof STEPS)[number];
export type Mode = 'vertices' | 'edges' | 'faces';
/** Edges by their index in `Connectivity.edges`. */
export type Selection = Record<Mode, ReadonlySet<number>>;
/**
 * Why elements are marked; of several causes the view shows the first: under the pointer, cannot be
 * met, cannot be built, nothing acts on them.
 */
export const MARKINGS = ['pointed', 'unmet', 'unbuildable', 'free'] as const;
export type Marking = (typeof MARKINGS)[number];
/** The colour of elements that fail, sRGB bytes. */
export const FAILED: Tint['colour'] = [214, 40, 57];
export type Tint = { vertices: Uint32Array; faces: Uint32Array; colour: [number, number, number] };
/** The original shape, `#V by 3`, and its values of the measure, `#F`, if there is one. */
type HeldOriginal = { positions: Float64Array; values: Float32Array | null };

export interface Store {
  get: () => Readonly<State>;
  /** The current state: a component or an effect follows the parts that it reads here. */
  state: Readonly<State>;
  set: (patch: Partial<State>) => void;
  /**
   * calls the listener now, and after every task in which one of the keys changed, until the
   * returned function is called
   */
  subscribe: (keys: (keyof State)[], listener: (state: Readonly<State>) => void) => () => void;
}

const INITIAL: State = {
  kinds: [],
  measures: [],
  operations: [],
  settings: [],
  model: null,
  fileName: '',
  firstExample: false,
  nothingOpen: false,
  example: null,
  document: null,
  frameChosen: null,
  refused: 0,
  numbers: null,
  running: false,
  refining: false,
  converged: false,
  halfway: false,
  tool: 'drag',
  shape: 'box',
  through: false,
  touching: false,
  adds: false,
  brush: 24,
  mode: 'vertices',
  selection: { vertices: new Set(), edges: new Set(), faces: new Set() },
  dragged: [],
  moved: null,
  gizmoPart: undefined,
  pointedAt: undefined,
  dragMs: 0,
  tints: {},
  rowColours: null,
  step: 'shape',
  openSteps: [],
  room: 'wide',
  measure: null,
  measureChosen: false,
  range: [0, 0],
  ownRange: AUTOMATIC,
  greatest: null,
  spread: null,
  corner: null,
  docked: null,
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
    legend: true,
    map: 'viridis',
  },
  camera: null,
  mouse: 'rhino',
  parallel: false,
  section: null,
  views: [],
  tape: null,
  flatMap: null,
  verdict: null,
  press: null,
  fitted: null,
  closedCard: false,
  heldOriginal: null,
  build: null,
  goalsRefused: '',
  presenting: false,
  plot: 'convergence',
  dark: false,
  renderer: 'starting',
  undoReplacing: '',
  redoReplacing: '',
  saved: '',
  status: '',
};

/** Whether the view can draw. */
export const isDrawn = ({ renderer }: Pick<State, 'renderer'>) =>
  renderer === 'webgpu' || renderer === 'webgl2';

/** Whether a constraint must be met, exactly or within a distance. */
export const isHard = ({ enabled, require }: ConstraintRow) => enabled && require !== 'soft';

/** Whether the shape is no longer the original; meeting constraints moves it before any iteration. */
export const hasMoved = (numbers: FrameNumbers | null) =>
  numbers !== null && (numbers.iteration > 0 || numbers.moved.max > 0);

/** Whether the fitted shapes are shown: as the last press has it, else as the user does. */
export const showsFitted = ({ fitted, display }: Pick<State, 'fitted' | 'display'>) =>
  fitted ?? display.shapes;

export function createStore(): Store {
  const all = signal(INITIAL);
  const keys = Object.keys(INITIAL) as (keyof State)[];
  const state = followed(all, keys);
  /** The listeners in their order, each with whether one of its keys has changed in this task. */
  const listeners = new Map<() => void, boolean>();
  let isQueued = false;

  function notify() {
    isQueued = false;
    for (const [call, isDue] of listeners) if (isDue) call();
  }

  return {
    get: () => all.peek(),
    state,
    set(patch) {
      all.value = { ...all.peek(), ...patch };
    },
    subscribe(keys, listener) {
      const call = () => {
        listeners.set(call, false);
        try {
          listener(all.peek());
        } catch (error) {
          reportError(error);
        }
      };
      const end = effect(() => {
        keys.forEach((key) => state[key]);
        listeners.set(call, true);
        if (!isQueued) queueMicrotask(notify);
        isQueued = true;
      });
      call();
      return () => {
        end();
        listeners.delete(call);
      };
    },
  };
}

/** The values of a signal, each of which is followed by itself. */
function followed(all: ReadonlySignal<State>, keys: (keyof State)[]) {
  const parts = keys.map((key) => {
    const part = computed(() => all.value[key]);
    return [key, { enumerable: true, get: () => part.value }] as const;
  });
  return Object.defineProperties({}, Object.fromEntries(parts)) as Readonly<State>;
}

/**
 * Returns what changes when the solver has another model: the view outlasts another mesh, and a press
 * another worker.
 */
export function withModel(
  loaded: Loaded,
  { restoring, reopensSameMesh }: Pick<SolverClient, 'restoring' | 'reopensSameMesh'>,
): Partial<State> {
  return {
    ...(!restoring && {
      ...{ camera: null, views: [], measureChosen: false, tolerances: {}, refining: false },
      ...{ frameChosen: null, section: null, fitted: null, presenting: false },
    }),
    ...(!reopensSameMesh && { press: null, closedCard: false }),
    model: loaded,
    document: null,
    numbers: null,
    greatest: null,
    halfway: false,
    flatMap: null,
    goalsRefused: '',
    heldOriginal: null,
    selection: NOTHING,
    dragged: [],
    dragMs: 0,
    tints: {},
    tape: null,
  };
}
