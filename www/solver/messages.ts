/**
 * Messages between the page and the solver's worker, which exchange nothing else.
 *
 * Page to worker: a {@link Command} has no answer; a {@link Request} carries an `id` and is
 * answered by exactly one `reply` or `refused` with the same `id`. Worker to page: those answers,
 * and the events of {@link FromWorker}. Events caused by a request are sent before its answer, so
 * that the page is up to date when its promise settles.
 *
 * The worker first sends `ready`, once; the page queues its messages until then.
 *
 * Positions travel in two buffers of `#V by 3` numbers, which are transferred, never copied: the
 * worker writes one and sends it in a `frame`; the page returns the previous one with `recycle`
 * after drawing. Without a free buffer no frame is sent, so that there is at most one frame per
 * picture, and the solver never waits.
 *
 * Lengths are in the unit of the mesh, energies in its square, times in ms; indices count from 0.
 */

import type {
  Angles,
  BuildCard,
  BuildNumber,
  BuildPreset,
  BuildReport,
  Choice as BuildChoice,
  Document as SceneDocument,
  ElementWords as ElementInfo,
  ExactOffer,
  FaceMeasure,
  ForecastWords,
  Frame as Numbers,
  HalfStep as Half,
  KindWords as KindInfo,
  Mode as PickMode,
  OfferedOperation,
  Operation,
  PanelStart,
  Preview,
  Refinement,
  Remeshing,
  RemeshingPreview,
  SelectRequest,
  Selector,
  Sent,
  Setting as SettingInfo,
  SheetPicture,
  SpatialPart,
  VariantRow,
  VariationProgress,
  Verdict,
  WorstElement,
} from '../pkg/engine/shape_up.js';
export type {
  BuildCard,
  BuildPreset,
  BuildReport,
  CheckRow,
  Choice as BuildChoice,
  ConstraintRow,
  Document as SceneDocument,
  ElementWords as ElementInfo,
  Energy,
  ExactOffer,
  ExactReport,
  FaceMeasure,
  Form,
  Frame as Numbers,
  HalfStep as Half,
  HandleRow as Handle,
  KindWords as KindInfo,
  LessonWords,
  Operation,
  PanelStart,
  Param as ParamInfo,
  ParamValue,
  PresetOffer as Preset,
  Preview,
  Require,
  SelectRequest,
  Selector,
  Setting as SettingInfo,
  SheetPicture,
  Sketch,
  Slide,
  SpatialPart,
  VariantRow,
  Verdict,
  WorstElement,
} from '../pkg/engine/shape_up.js';

// Types declared by Rust: a changed field becomes a type error here.

/**
 * An opened model: `files` are those it was opened from; `undoLost` is the reason why its saved
 * undo history is lost, or empty.
 */
export type Loaded = import('../pkg/engine/shape_up.js').Loaded & {
  files: string[];
  undoLost: string;
};
export type Remedy = Omit<import('../pkg/engine/shape_up.js').Remedy, 'edit'> & { edit: Edit };

// The declarations, sent once in `ready`: all data from which the page makes its controls for kinds,
// elements, measures, selections, settings.

/** The id of a {@link FaceMeasure}. */
export type Measure = string;

/** An edit of the document, which is one step of undo. */
export type Edit = Sent<import('../pkg/engine/shape_up.js').Edit>;

/** The connectivity of the mesh, sent once. */
export interface Connectivity {
  /** `#F + 1` */
  faceOffsets: Uint32Array;
  faceIndices: Uint32Array;
  /** `#curves + 1` */
  curveOffsets: Uint32Array;
  curveIndices: Uint32Array;
  /** `#E by 2` */
  edges: Uint32Array;
}

/** The colour of the constraint row that acts on each face and each vertex. */
export interface RowColours {
  /** `#F`: 0 for none, else an index in `palette` plus one */
  faces: Uint8Array;
  /** `#V`: the same for constraints that cover no whole face */
  vertices: Uint8Array;
  /** three components from 0 to 1 per colour */
  palette: Float32Array;
}

/** The projected points of all enabled constraints. */
export interface Projections {
  /** `#points`: the vertex of each point */
  vertices: Uint32Array;
  /** `#points by 3`: from the vertex to the point */
  displacements: Float32Array;
  /** `#points`: an index in `palette` plus one */
  colours: Uint8Array;
  /** pairs of points */
  outlines: Uint32Array;
  /** three components from 0 to 1 per colour */
  palette: Float32Array;
}

/**
 * A conformal flat map (Eq. 14) of the shape at the time of the request. The quasi-conformal error
 * of a triangle is the ratio of its larger to its smaller stretch: 1 if angles are preserved.
 */
export interface Parametrization {
  /** `#V by 2`, in the unit of the mesh */
  uv: Float64Array;
  /** `#F`: largest error of the face's triangles; NaN without area */
  faceErrors: Float32Array;
  /** faces by error, in bins of equal width from 1 to `high`; the last one includes all above */
  histogram: Uint32Array;
  /** 99th percentile of the errors */
  high: number;
  /** error, weighted by area */
  mean: number;
  /** error */
  max: number;
  /** number of flipped triangles */
  flipped: number;
  /** faces with flipped triangles */
  flippedFaces: Uint32Array;
  /** number of connected components of the surface */
  parts: number;
  /** components without a boundary, which cannot be mapped without folds */
  closedParts: number;
  /** faces not on the map: without area, or with the vertices of another face */
  leftOut: number;
  eigenvalue: number;
  seconds: number;
  secondsOf: Record<'assemble' | 'order' | 'factor' | 'iterate', number>;
}

/** Settings whose flat map has fewer flipped triangles. */
export interface FewerFlips {
  weights: MapWeights;
  norm: MapNorm;
  /** number of flipped triangles */
  flipped: number;
  /** error, weighted by area */
  mean: number;
}

/** Weights of polygons, and normalisation of the map: names as on the command line. */
export type MapWeights = 'inverse-area' | 'one' | 'lscm';
export type MapNorm = 'boundary' | 'vertices';

export type NamedBytes = { name: string; bytes: Uint8Array };

/** Data saved with a scene to resume it; the byte arrays are read by the solver only. */
export interface Saved {
  /** of the scene */
  iteration: number;
  /** its undo and redo steps */
  history: Uint8Array | null;
  /** of a run or a drag that started from the scene */
  progress: Uint8Array | null;
}

/**
 * Commands; they have no answer.
 *
 * - `run`, `pause`: iterate until converged, or stop. A run also ends when the shape collapses
 *   outside a drag, unless `ignoreCollapse`.
 * - `drag`: targets (`#vertices by 3`) of the dragged handles. The first phase is `start`, or
 *   `make`, which makes the vertices handles first. Of several `move`s only the last one counts;
 *   `time` is that of its event. During a drag the solver iterates even when paused.
 * - `show`: what to send with each frame besides positions.
 * - `recycle`: returns a buffer of positions.
 * - `ping`: answered by `pong`.
 */
export type Command =
  | { type: 'run'; ignoreCollapse?: boolean }
  | { type: 'pause' }
  | Drag
  | {
      type: 'show';
      measure: Measure | null;
      shapes: boolean;
      projections: boolean;
      corners: boolean;
    }
  | { type: 'recycle'; positions: Float64Array }
  | { type: 'ping' };

export type Drag = {
  type: 'drag';
  vertices: Uint32Array;
  targets: Float64Array;
  time?: number;
  phase: 'make' | 'start' | 'move' | 'end' | 'cancel';
};

/**
 * Requests, answered by `reply` with the value named in {@link Replies}, or by `refused`.
 *
 * - `open`: opens the first scene, or else the first file; the others may be files that it names.
 *   If refused, the current model stays. `saved` is the data saved with a scene; `frame` gives the
 *   unit and axis of a mesh file that has none: `# units: m`, `# up: y`; `weld: false` keeps the
 *   separate vertices of faces in a mesh file; `solved` runs before anything is shown, only for
 *   models known to converge quickly.
 * - `edit`, `undo`, `redo`, `step`; `halfStep`: the local step, or the global step after it.
 * - `makePanels`: adds one kind of constraint to all panels, within the tolerance, and runs.
 *   `editAndRun`: edits and runs. Each is one step of undo.
 * - `exactOffer`: the cost of meeting constraints exactly instead of within a distance, tried
 *   alongside everything else; ends early with null when something changes. `makeExact`: applies
 *   the exact shape tried, if it belongs to the current one, as or in a step of undo.
 * - `improvement`: searches for lower energy among equally exact shapes, until `endTrial` or a
 *   change; returns how far it came, which `makeExact` applies, or null if that no longer belongs to
 *   the current shape and constraints.
 * - `variations`: other shapes that are equally exact, and kept shapes; see {@link VariationAsk}.
 * - `members`: elements on which a constraint acts. `rowColours`: the colours of all rows.
 *   `previews`: the result of adding each kind at some selectors. `select`: the new selection.
 * - `worst`: the worst faces by a measure, or the worst constraints of a row. `flawed`: the
 *   elements with a flaw of a {@link Problem}, or `zero-size-faces`. `results`: a student's submission.
 * - `verdict`: how many panels meet their constraints within a tolerance. `forecast`: how far the
 *   mesh will move for that.
 * - `remedies`: changes that lower the worst distance, tried on a copy; ends early on a change.
 * - `mostFaces`: number of faces up to which this computer stays interactive.
 * - `originalValues`, `originalPositions`: values of a measure, and positions, of the original.
 *   `angles`: angles of the face corners.
 * - `parametrize`: ends a run. Refused without faces or without area.
 * - `missingFiles`: paths of files that the scene names and that are missing.
 * - `fewerFlips`: ends a run; the map settings with the fewest flips, if fewer than `flipped`.
 * - `scene`, `obj`, `table`: the texts of the files. An `obj` with `unwelded` has the vertices and
 *   faces of a file that was welded, one with `uv` (`#V by 2`) has those as texture coordinates. A
 *   `table` has the errors of the faces, the energies of the iterations, or the angles of the
 *   corners, as CSV.
 * - `trace`: the energies of the iterations up to the current shape, subsampled evenly for a plot.
 * - `meshOperations`: the operations on the mesh. `remeshing`: previews one of them. `refinements`:
 *   previews refining once, twice and so on.
 * - `exampleFile`: the bytes of an example's scene or mesh, by the name of the file.
 */
export type Request =
  | {
      type: 'open';
      files: NamedBytes[];
      saved?: Saved;
      frame?: string;
      solved?: boolean;
      weld?: boolean;
    }
  | { type: 'edit'; edit: Edit }
  | { type: 'makePanels'; kind: string; tolerance: number; from: PanelStart }
  | { type: 'editAndRun'; edit: Edit }
  | { type: 'exactOffer' }
  | { type: 'improvement' }
  | { type: 'endTrial' }
  | { type: 'makeExact'; joins: boolean }
  | { type: 'variations'; ask: VariationAsk }
  | { type: 'undo' }
  | { type: 'redo' }
  | { type: 'step' }
  | { type: 'halfStep' }
  | { type: 'originalValues'; measure: Measure }
  | { type: 'originalPositions' }
  | { type: 'angles' }
  | { type: 'members'; constraint: number }
  | { type: 'rowColours' }
  | { type: 'previews'; places: Selector[] }
  | { type: 'select'; request: SelectRequest }
  | { type: 'worst'; measure: Measure | null; row: number | null; count: number }
  | { type: 'flawed'; flaw: string }
  | { type: 'verdict'; tolerance: number }
  | { type: 'forecast' }
  | { type: 'remedies' }
  | { type: 'mostFaces' }
  | { type: 'buildNumbers' }
  | { type: 'setBuildNumbers'; ids: string[]; values: Float64Array }
  | { type: 'results'; student: string; time: string }
  | { type: 'scene' }
  | { type: 'parametrize'; weights: MapWeights; norm: MapNorm }
  | { type: 'fewerFlips'; flipped: number }
  | { type: 'missingFiles'; files: NamedBytes[] }
  | { type: 'obj'; uv?: Float64Array; unwelded?: boolean }
  | { type: 'table'; table: 'errors' | 'convergence' | 'angles' }
  | { type: 'trace' }
  | { type: 'exampleFile'; name: string }
  | { type: 'meshOperations' }
  | { type: 'refinements'; scheme: string; keep: number }
  | { type: 'remeshing'; asked: Remeshing };

/**
 * `find` begins the search for variations of an exact shape, `advance` continues it for a slice,
 * `displacement` is that of all vertices for a coefficient of one. `show`: the shape plus the
 * variations times their coefficients; `project` projects that back onto the constraints, `keep`
 * makes it the design as one step of undo, `leave` discards it. `table`, `positions`: kept shapes.
 */
export type VariationAsk =
  | { what: 'find' }
  | { what: 'advance' }
  | { what: 'displacement'; index: number }
  | { what: 'show'; coefficients: Float64Array }
  | { what: 'project'; coefficients: Float64Array }
  | { what: 'keep' }
  | { what: 'leave' }
  | { what: 'table'; tolerance: number }
  | { what: 'positions'; index: number };

/** Answers to these. */
export interface VariationAnswers {
  /** whether there can be any */
  find: boolean;
  advance: VariationProgress;
  /** `#V by 3` */
  displacement: Float32Array;
  /** whether the variations belong to the current shape */
  show: boolean;
  /** fraction reached; null if they belong to another shape */
  project: number | null;
  /** whether there was anything to keep */
  keep: boolean;
  leave: undefined;
  table: VariantRow[];
  /** `#V by 3` */
  positions: Float64Array;
}

/** Answers to the requests. */
export interface Replies {
  open: Loaded;
  edit: null;
  makePanels: null;
  editAndRun: null;
  exactOffer: ExactOffer | null;
  improvement: ExactOffer | null;
  endTrial: null;
  /** whether it was done */
  makeExact: boolean;
  /** see `VariationAnswers` */
  variations: unknown;
  /** the name of what was undone */
  undo: string | null;
  /** the name of what was redone */
  redo: string | null;
  /** whether it has converged */
  step: boolean;
  halfStep: Half;
  /** `#F`; NaN if a face has none */
  originalValues: Float32Array;
  /** `#V by 3` */
  originalPositions: Float64Array;
  angles: Angles;
  members: { faces: Uint32Array; vertices: Uint32Array };
  rowColours: RowColours;
  /** `#kinds by #places`, null if nothing fits */
  previews: (Preview | null)[][];
  select: Record<PickMode, Uint32Array>;
  worst: WorstElement[];
  flawed: Record<PickMode, Uint32Array>;
  /** null if nothing is required of the panels */
  verdict: Verdict | null;
  /** null if no kind is offered for all panels */
  forecast: ForecastWords | null;
  /** most effective first */
  remedies: Remedy[];
  mostFaces: number;
  buildNumbers: BuildNumber[];
  setBuildNumbers: null;
  results: string;
  parametrize: Parametrization;
  fewerFlips: FewerFlips | null;
  missingFiles: string[];
  scene: string;
  obj: string;
  table: string;
  /** `#iterations by 6`: iteration, shape, close, smooth, handles, total */
  trace: Float64Array;
  exampleFile: Uint8Array;
  meshOperations: OfferedOperation[];
  remeshing: RemeshingPreview;
  refinements: Refinement[];
}

export type ToWorker = Command | (Request & { id: number });

/**
 * - `ready`: the solver accepts messages. Sent first, once.
 * - `loading`: before that, the progress of fetching its module, if it takes long.
 * - `model`: another mesh is open; without a name and files, the current mesh was refined or
 *   refining was undone. `positions` is one of the two buffers.
 * - `document`: after every edit and every load.
 * - `scene`: the scene file's text with its undo history, whenever it changed and the solver is
 *   idle: for autosave, and to restore a worker that died. `progress`: at intervals, the progress
 *   of a run or a drag since then.
 * - `frame`: a state of the iteration. `values` are those of `measure`, `#F`; `corners`, for
 *   measures of vertices, those of the vertices, `#V`, whose maximum a face has; `shapes` the
 *   fitted shapes, eight numbers each; `projections` the projected points of the constraints;
 *   `answers` the time of the latest drag move that it shows, and the milliseconds since it came.
 * - `activity`: whether the solver runs (Run was pressed and it has not converged); sent after the
 *   frame that belongs to it.
 * - `collapsed`: the run has ended with a collapsed shape (`collapse` tells how), not converged.
 * - `trouble`: an iteration failed; the last good state stays.
 * - `died`: the state is unusable, the worker must be replaced.
 * - `working`: work begins that may take long, with no message until then. `pong`: sign of life.
 * - `refused`: `path` is the position of the error in the scene, such as `constraints[0].length`;
 *   empty if it is not about a scene.
 */
export type FromWorker =
  | {
      type: 'ready';
      kinds: KindInfo[];
      elements: ElementInfo[];
      measures: FaceMeasure[];
      operations: Operation[];
      settings: SettingInfo[];
    }
  | { type: 'loading'; bytes: number; all: number }
  | { type: 'model'; loaded: Loaded; connectivity: Connectivity; positions: Float64Array }
  | { type: 'document'; document: SceneDocument }
  | { type: 'scene'; text: string; history: Uint8Array; iteration: number }
  | { type: 'progress'; bytes: Uint8Array; iteration: number }
  | {
      type: 'frame';
      numbers: Numbers;
      positions: Float64Array;
      measure: Measure | null;
      values: Float32Array | null;
      corners: Float32Array | null;
      shapes: Float64Array | null;
      projections: Projections | null;
      answers: [number, number] | null;
    }
  | { type: 'activity'; running: boolean; converged: boolean }
  | { type: 'collapsed'; collapse: string }
  | { type: 'trouble'; message: string }
  | { type: 'died'; message: string }
  | { type: 'working' }
  | { type: 'pong' }
  | { type: 'reply'; id: number; value: unknown }
  | { type: 'refused'; id: number; message: string; path: string };

/** The messages of the worker by their type. */
export type WorkerEvents = { [T in FromWorker['type']]: Extract<FromWorker, { type: T }> };

/**
 * Handlers of the requests: a missing or surplus one, or a wrong type of answer, is a type error.
 */
export type RequestHandlers = {
  [T in Request['type']]: (
    message: Extract<Request, { type: T }>,
  ) => Replies[T] | Promise<Replies[T]>;
};
/** Handlers of the commands. */
export type CommandHandlers = {
  [T in Command['type']]: (message: Extract<Command, { type: T }>) => void;
};

/** Duration of a slice of iterations between messages, in milliseconds. */
export const SLICE_MS = 8;

/** Numbers per iteration in the answer to `trace`. */
export const TRACE_WIDTH = 6;

/**
 * Messages of the Rhino worker, which handles one request: read a file as the mesh in it, write a
 * scene with the table of its face errors, or write the parts to be built.
 */
export type RhinoRequest =
  | { type: 'read'; file: NamedBytes }
  | { type: 'write'; scene: string; errors: string }
  | { type: 'writeParts'; parts: SpatialPart[]; symbol: string };

export type RhinoReplies = {
  read: NamedBytes;
  write: Uint8Array<ArrayBuffer>;
  writeParts: Uint8Array<ArrayBuffer>;
};

export type RhinoAnswer = { value: RhinoReplies[keyof RhinoReplies] } | { refused: string };

/** All build settings; a scene contains only those that differ from the default. */
export type BuildSettings = Required<import('../pkg/engine/shape_up.js').BuildSettings>;

/**
 * The offset as the view shows it: points `#V by 3`, edges (two vertices each), and the vertices
 * and panels that exceed a limit.
 */
export type OffsetLayer = {
  points: Float64Array;
  edges: Uint32Array;
  vertices: Uint32Array;
  panels: Uint32Array;
};

/**
 * Messages of the fabrication worker. `build` makes the parts of a shape (positions `#V by 3`) in a
 * unit of `metres` metres, and draws at most `sheets` sheets; the others refer to the last build.
 * `moveLayer` changes the distance of its offset, and `reshape` its positions, during a drag.
 * `reportPage` is an HTML document, with a picture from `camera`, two angles in radians, or from the
 * default view.
 */
export type BuildRequest =
  | { type: 'offers' }
  | { type: 'choices' }
  | { type: 'numbers' }
  | { type: 'zip'; zUp: boolean }
  | { type: 'spatialParts'; zUp: boolean }
  | { type: 'moveLayer'; distance: number }
  | { type: 'reshape'; positions: Float64Array }
  | { type: 'reportPage'; title: string; zUp: boolean; camera: Float64Array | null; link: string }
  | {
      type: 'build';
      positions: Float64Array;
      offsets: Uint32Array;
      indices: Uint32Array;
      settings: BuildSettings;
      symbol: string;
      metres: number;
      sheets: number;
    };

export interface BuildReplies {
  offers: { presets: BuildPreset[]; defaults: BuildSettings };
  build: { report: BuildReport; sheets: SheetPicture[]; layer: OffsetLayer };
  moveLayer: { report: BuildCard; layer: OffsetLayer } | null;
  reshape: { report: BuildCard; layer: OffsetLayer } | null;
  choices: BuildChoice[];
  /** that a lesson may bound, by id */
  numbers: [string, number][];
  reportPage: string | null;
  spatialParts: SpatialPart[];
  zip: Uint8Array<ArrayBuffer>;
}

/**
 * How the messages of failed `import()`, `fetch` and streamed WebAssembly begin in Chromium, Firefox
 * and Safari. All are type errors.
 */
const NOT_FETCHED =
  /^(Failed to fetch( dynamically imported module: | \(|$)|error loading dynamically imported module\b|Importing a module script failed|NetworkError when attempting to fetch|Load failed( \(|$)|WebAssembly compilation aborted: Network error)/;
/** The same of the generated code that loads style sheets and modules of WebAssembly. */
const NOT_LOADED = /^(Unable to preload CSS for \S+$|failed to fetch Wasm: \d+ )/;

/**
 * Whether a part of the page could not be fetched. Other errors may have the same words in them, as
 * in the name of a file.
 */
const isNotFetched = (thrown: unknown, message: string) =>
  (thrown instanceof TypeError && NOT_FETCHED.test(message)) ||
  (thrown instanceof Error && NOT_LOADED.test(message));

/** Returns a one-line message for any thrown value. */
export function messageOf(thrown: unknown): string {
  const hasMessage = thrown && typeof thrown === 'object' && 'message' in thrown;
  const message = String(hasMessage ? thrown.message : thrown);
  return isNotFetched(thrown, message)
    ? 'A part of the page could not be fetched. Check the network.'
    : message;
}
