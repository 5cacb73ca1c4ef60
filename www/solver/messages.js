/**
 * The messages between the page and the solver's worker. Both sides import this file; nothing else
 * crosses.
 *
 * Page to worker: a {@link Command} is told and forgotten; a {@link Request} carries an `id` and is
 * answered by exactly one `reply` or `refused` with the same `id`. Worker to page: those answers,
 * and the events of {@link FromWorker}. Events that a request causes are sent before its answer, so
 * that the page is up to date when its promise settles.
 *
 * The worker says `ready` first, once; the page holds back what it has to say until then.
 *
 * Positions travel in two buffers of `#V by 3` numbers that are transferred, never copied: the
 * worker writes one and sends it in a `frame`; the page gives back the one before it by `recycle`
 * when it has drawn. No free buffer, no frame: so there is at most one frame per picture, and the
 * solver never waits.
 *
 * Lengths are in the unit of the mesh, energies in its square, times in milliseconds. Indices
 * count from 0.
 */

// What Rust says of its own types: a field that changes there is an error of types here.
/** @typedef {import("../pkg/solver/shape_up.js").ConstraintRow} ConstraintRow */
/** @typedef {import("../pkg/solver/shape_up.js").Energy} Energy */
/** @typedef {import("../pkg/solver/shape_up.js").ExactOffer} ExactOffer */
/** @typedef {import("../pkg/solver/shape_up.js").ExactReport} ExactReport */
/** @typedef {import("../pkg/solver/shape_up.js").Frame} Numbers */
/** @typedef {import("../pkg/solver/shape_up.js").HalfStep} Half */
/** @typedef {import("../pkg/solver/shape_up.js").HandleRow} Handle */
/** @typedef {import("../pkg/solver/shape_up.js").LessonWords} LessonWords */
/** @typedef {import("../pkg/solver/shape_up.js").Slide} Slide */
/** @typedef {import("../pkg/solver/shape_up.js").Moved} Moved */
/** @typedef {import("../pkg/solver/shape_up.js").PanelOffer} PanelOffer */
/** @typedef {import("../pkg/solver/shape_up.js").PresetOffer} Preset */
/** @typedef {import("../pkg/solver/shape_up.js").Preview} Preview */
/** @typedef {import("../pkg/solver/shape_up.js").Problem} Problem */
/** @typedef {import("../pkg/solver/shape_up.js").Document} SceneDocument */
/** @typedef {import("../pkg/solver/shape_up.js").VariantRow} VariantRow */
/** @typedef {import("../pkg/solver/shape_up.js").VariationProgress} VariationProgress */
/** @typedef {import("../pkg/solver/shape_up.js").Verdict} Verdict */
/** @typedef {import("../pkg/solver/shape_up.js").Weights} Weights */
/** @typedef {import("../pkg/solver/shape_up.js").WorstElement} WorstElement */

/**
 * What was opened: from `files`; `undoLost` says why the steps of undo that were saved with it are gone, and
 * is empty when they are not.
 * @typedef {import("../pkg/solver/shape_up.js").Loaded & { files: string[], undoLost: string }} Loaded
 */
/** @typedef {Omit<import("../pkg/solver/shape_up.js").Remedy, "edit"> & { edit: Edit }} Remedy */

/** @typedef {import("./declarations.js").ElementInfo} ElementInfo */
/** @typedef {import("./declarations.js").FaceMeasure} FaceMeasure */
/** @typedef {import("./declarations.js").Form} Form */
/** @typedef {import("./declarations.js").KindInfo} KindInfo */
/** @typedef {import("./declarations.js").Measure} Measure */
/** @typedef {import("./declarations.js").Operation} Operation */
/** @typedef {import("./declarations.js").ParamInfo} ParamInfo */
/** @typedef {import("./declarations.js").ParamValue} ParamValue */
/** @typedef {import("./declarations.js").PickMode} PickMode */
/** @typedef {import("./declarations.js").SettingInfo} SettingInfo */
/** @typedef {import("./declarations.js").Sketch} Sketch */

/** @typedef {import("../pkg/solver/shape_up.js").Selector} Selector */
/** @typedef {import("../pkg/solver/shape_up.js").Require} Require */
/** @typedef {import("../pkg/solver/shape_up.js").LessonFile} Lesson */
/** @typedef {import("../pkg/solver/shape_up.js").SelectRequest} SelectRequest */

/**
 * One edit of the document; each is one step of undo.
 * @typedef {import("../pkg/solver/shape_up.js").Sent<import("../pkg/solver/shape_up.js").Edit>} Edit
 */

/**
 * The connectivity of the mesh, sent once.
 * @typedef {object} Connectivity
 * @property {Uint32Array} faceOffsets `#F + 1`
 * @property {Uint32Array} faceIndices
 * @property {Uint32Array} curveOffsets `#curves + 1`
 * @property {Uint32Array} curveIndices
 * @property {Uint32Array} edges `#E by 2`
 */

/**
 * The colour of the row of constraints that acts on each face and each vertex.
 * @typedef {object} RowColours
 * @property {Uint8Array} faces `#F`: 0 where there is none, else one more than a place in `palette`
 * @property {Uint8Array} vertices `#V`: the same for constraints that cover no whole face
 * @property {Float32Array} palette three parts from 0 to 1 per colour
 */

/**
 * The projected points of all constraints that are on.
 * @typedef {object} Projections
 * @property {Uint32Array} vertices `#points`: the vertex that each is the projection of
 * @property {Float32Array} ways `#points by 3`: from the vertex to the point
 * @property {Uint8Array} colours `#points`: one more than a place in `palette`
 * @property {Uint32Array} outlines pairs of points
 * @property {Float32Array} palette three parts from 0 to 1 per colour
 */

/**
 * A flat map that keeps angles (Eq. 14), of the shape as it was when it was asked for. The
 * quasi-conformal error of a triangle is its greater over its smaller stretch: 1 where angles are kept.
 * @typedef {object} Parametrization
 * @property {Float64Array} uv `#V by 2`, units of the mesh
 * @property {Float32Array} faceErrors `#F`: of each face the greatest error of its triangles; not a number without area
 * @property {Uint32Array} histogram faces by error, in bars of equal width from 1 to `high`; the last one holds those beyond too
 * @property {number} high what 99 of a hundred faces do not exceed
 * @property {number} mean error, weighted by area
 * @property {number} max error
 * @property {number} flipped triangles that the map turns over
 * @property {Uint32Array} flippedFaces those that have some of these
 * @property {number} parts connected parts of the surface
 * @property {number} closedParts those without a boundary, which cannot be flattened without folds
 * @property {number} leftOut faces without area, or on the same vertices as another: they are not on the map
 * @property {number} eigenvalue
 * @property {number} seconds
 * @property {Record<"assemble" | "order" | "factor" | "iterate", number>} secondsOf
 */

/**
 * Settings whose flat map turns fewer triangles over.
 * @typedef {object} FewerFlips
 * @property {MapWeights} weights
 * @property {MapNorm} norm
 * @property {number} flipped triangles that the map turns over
 * @property {number} mean error, weighted by area
 */

/** What a polygon counts, and what is kept from shrinking to a point: the words of the command line. */
/** @typedef {"inverse-area" | "one" | "lscm"} MapWeights */
/** @typedef {"boundary" | "vertices"} MapNorm */

/** @typedef {{ name: string, bytes: Uint8Array }} NamedBytes */

/**
 * What is saved beside a scene, so that it goes on where it stood; bytes that only the solver reads.
 * @typedef {object} Saved
 * @property {number} iteration of the scene
 * @property {Uint8Array | null} history its steps of undo and redo
 * @property {Uint8Array | null} progress of a run or a drag that began with it
 */

/**
 * Told and forgotten.
 *
 * - `run`, `pause`: iterate until converged, or stop. A run ends too when the shape collapses while nobody
 *   drags, unless it shall `goOn`.
 * - `drag`: targets (`#vertices by 3`) for handles under the pointer; `make` makes them handles first,
 *   instead of `start`. Of several `move`s only the last one counts; `time` is that of its event.
 *   While something is dragged the solver iterates even when paused.
 * - `show`: what to send with each frame besides positions.
 * - `recycle`: gives a buffer of positions back.
 * - `cancelExperiment`: ends it; what was measured stays.
 * - `ping`: answered by `pong`.
 * @typedef {{ type: "run", goOn?: boolean }
 *   | { type: "pause" }
 *   | Drag
 *   | { type: "show", measure: Measure | null, shapes: boolean, projections: boolean,
 *       corners: boolean }
 *   | { type: "recycle", positions: Float64Array }
 *   | { type: "cancelExperiment" }
 *   | { type: "ping" }} Command
 */

/** @typedef {{ type: "drag", vertices: Uint32Array, targets: Float64Array, time?: number,
 *   phase: "make" | "start" | "move" | "end" | "cancel" }} Drag */

/**
 * Answered by `reply` with the value named in {@link Replies}, or `refused`.
 *
 * - `open`: the first file that is a scene, else the first file; the others may be the mesh that it
 *   names. When it is refused the old model stays. `saved` is what was saved beside a scene;
 *   `frame` what a mesh file is taken for that does not say its unit and axis: `# units: m`, `# up: y`;
 *   `weld: false` leaves a mesh file whose faces have their own vertices as it came; `solved` runs before anything is shown: only for what is known to converge soon.
 * - `edit`, `undo`, `redo`, `step`; `halfStep`: the local step, or the global step after it.
 * - `makePanels`: asks one shape of all panels, within the tolerance, from the shape as it is or `afresh` from the
 *   original, and runs. `editAndRun`: makes an edit and runs. Either is one step of undo.
 * - `exactOffer`: what it would cost to be exact instead of within a distance, tried beside all else; ends early,
 *   with null, when something changes. `makeExact`: takes the exact shape that was tried, if it is still of the
 *   current one, as a step of undo or a part of the last one.
 * - `improvement`: looks for less energy among the shapes that are as exact, until `endTrial` or something changes;
 *   how far it came, which `makeExact` takes.
 * - `variations`: other shapes that are as exact, and those that were kept; see {@link VariationAsk}. `faceValues` can
 *   be of one that was kept, a `variant`.
 * - `members`: what a constraint acts on. `rowColours`: the colours of all of them. `previews`: what
 *   adding one of each kind at each of some places would make. `select`: what is selected then.
 * - `worst`: the worst faces by a measure, or the worst constraints of a row. `flawed`: the elements
 *   with a flaw of a {@link Problem}, or `zero-size-faces`. `results`: what a student hands in.
 * - `verdict`: how many panels are as asked, within a tolerance. `forecast`: how far the mesh will move for that.
 * - `remedies`: changes that lower the worst distance, tried on a copy; ends early when something changes.
 * - `mostFaces`: of a mesh that this machine works with at once.
 * - `faceValues`: of a measure, of the current shape or the original. `cornerValues`: those of the
 *   vertices, where they have any. `originalPositions`: where the vertices of the original are. `angles`:
 *   of the corners of the faces.
 * - `parametrize`: ends a run. Refused where there is no face, or no area.
 * - `missingFiles`: the paths of files that the scene among them names and that are not there.
 * - `fewerFlips`: ends a run; the settings whose map turns fewest over, of those that turn fewer than `flipped`.
 * - `scene`, `obj`, `table`: the texts of the files; an `obj` `asItCame` has the vertices and faces of a file
 *   that was welded, one with `uv` (`#V by 2`) has them as texture
 *   coordinates; a `table` has the errors of the faces, the energies of the iterations, or the angles of the
 *   corners, as CSV.
 * - `trace`: the energies of the iterations that led to the current shape; of very many as many as a plot
 *   can show, evenly spaced.
 * - `meshOperations`: what can be done to the mesh. `remeshing`: what one of them would make of it, `refinements`: what
 *   refining would, once, twice and so on.
 * - `comparison`: what the experiment on whatever is open declares.
 * - `runExperiment`: starts the experiment of an example, on its files, the scene first, or the comparison on
 *   what is open, from its original shape; the model that is open is not touched. `experimentCsv`: what was
 *   measured.
 * @typedef {{ type: "open", files: NamedBytes[], saved?: Saved, frame?: string,
 *       solved?: boolean, weld?: boolean }
 *   | { type: "edit", edit: Edit }
 *   | { type: "makePanels", kind: string, tolerance: number, afresh: boolean }
 *   | { type: "editAndRun", edit: Edit }
 *   | { type: "exactOffer" }
 *   | { type: "improvement" }
 *   | { type: "endTrial" }
 *   | { type: "makeExact", joins: boolean }
 *   | { type: "variations", ask: VariationAsk }
 *   | { type: "undo" }
 *   | { type: "redo" }
 *   | { type: "step" }
 *   | { type: "halfStep" }
 *   | { type: "faceValues", measure: Measure, original: boolean, variant?: number }
 *   | { type: "cornerValues", measure: Measure }
 *   | { type: "originalPositions" }
 *   | { type: "angles" }
 *   | { type: "members", constraint: number }
 *   | { type: "rowColours" }
 *   | { type: "previews", places: Selector[] }
 *   | { type: "select", request: SelectRequest }
 *   | { type: "worst", measure: Measure | null, row: number | null, count: number }
 *   | { type: "flawed", flaw: string }
 *   | { type: "verdict", tolerance: number }
 *   | { type: "forecast" }
 *   | { type: "remedies" }
 *   | { type: "mostFaces" }
 *   | { type: "buildNumbers" }
 *   | { type: "tellBuild", ids: string[], values: Float64Array }
 *   | { type: "results", student: string, time: string }
 *   | { type: "scene" }
 *   | { type: "parametrize", weights: MapWeights, norm: MapNorm }
 *   | { type: "fewerFlips", flipped: number }
 *   | { type: "missingFiles", files: NamedBytes[] }
 *   | { type: "obj", uv?: Float64Array, asItCame?: boolean }
 *   | { type: "table", table: "errors" | "convergence" | "angles" }
 *   | { type: "trace" }
 *   | { type: "comparison" }
 *   | { type: "runExperiment", of: { example: string, files: NamedBytes[] } | null, iterations: number }
 *   | { type: "experimentCsv" }
 *   | { type: "meshOperations" }
 *   | { type: "refinements", scheme: string, keep: number }
 *   | { type: "remeshing", asked: import("../pkg/solver/shape_up.js").Remeshing }} Request
 */

/**
 * `find` begins to look for ways to change a shape that is exact, `advance` goes on for a slice, `way` is that of every
 * vertex for a coefficient of one. `show`: the shape plus the ways times their coefficients; `reach` brings that back
 * onto the constraints, `keep` makes it the design, one step of undo, `leave` goes back from it. `table` and
 * `positions` are of the shapes that were kept.
 * @typedef {{ what: "find" } | { what: "advance" } | { what: "way", index: number }
 *   | { what: "show", coefficients: Float64Array } | { what: "reach", coefficients: Float64Array }
 *   | { what: "keep" } | { what: "leave" }
 *   | { what: "table", tolerance: number } | { what: "positions", index: number }} VariationAsk
 */

/**
 * What each of these is answered with.
 * @typedef {object} VariationAnswers
 * @property {boolean} find whether there can be any
 * @property {VariationProgress} advance
 * @property {Float32Array} way `#V by 3`
 * @property {boolean} show whether they are of the shape that is open
 * @property {number | null} reach the part of the way; null where they are of another shape
 * @property {boolean} keep whether there was anything to keep
 * @property {undefined} leave
 * @property {VariantRow[]} table
 * @property {Float64Array} positions `#V by 3`
 */

/**
 * What each request is answered with.
 * @typedef {object} Replies
 * @property {Loaded} open
 * @property {null} edit
 * @property {null} makePanels
 * @property {null} editAndRun
 * @property {ExactOffer | null} exactOffer
 * @property {ExactOffer | null} improvement
 * @property {null} endTrial
 * @property {boolean} makeExact whether it was done
 * @property {unknown} variations as `VariationAnswers` says
 * @property {string | null} undo the name of what was undone
 * @property {string | null} redo the name of what was redone
 * @property {boolean} step whether it has converged
 * @property {Half} halfStep
 * @property {Float32Array} faceValues `#F`; not a number where a face has none
 * @property {Float32Array | undefined} cornerValues `#V`
 * @property {Float64Array} originalPositions `#V by 3`
 * @property {import("../pkg/solver/shape_up.js").Angles} angles
 * @property {{ faces: Uint32Array, vertices: Uint32Array }} members
 * @property {RowColours} rowColours
 * @property {(Preview | null)[][]} previews `#kinds by #places`, null where nothing fits
 * @property {Record<PickMode, Uint32Array>} select
 * @property {WorstElement[]} worst
 * @property {Record<PickMode, Uint32Array>} flawed
 * @property {Verdict | null} verdict null where nothing is asked of the panels
 * @property {string | null} forecast null where no shape is offered for all panels
 * @property {Remedy[]} remedies the greatest help first
 * @property {number} mostFaces
 * @property {BuildNumber[]} buildNumbers
 * @property {null} tellBuild
 * @property {string} results
 * @property {Parametrization} parametrize
 * @property {FewerFlips | null} fewerFlips
 * @property {string[]} missingFiles
 * @property {string} scene
 * @property {string} obj
 * @property {string} table
 * @property {Float64Array} trace `#iterations by 6`: iteration, shape, close, smooth, handles, total
 * @property {import("./examples.js").Experiment} comparison
 * @property {null} runExperiment
 * @property {string} experimentCsv
 * @property {import("../pkg/solver/shape_up.js").OfferedOperation[]} meshOperations
 * @property {import("../pkg/solver/shape_up.js").RemeshingPreview} remeshing
 * @property {import("../pkg/solver/shape_up.js").Refinement[]} refinements
 */

/**
 * What a method of an experiment has done: its index, why it ended, and per iteration its number, the
 * seconds, and the quantities of the experiment.
 * @typedef {{ method: number, endedBy: string | null, samples: Float64Array }} ExperimentNews
 */

/** @typedef {Command | (Request & { id: number })} ToWorker */

/**
 * - `ready`: the solver can be spoken to. First, once.
 * - `loading`: before that, how much of its module is here, where it takes a while.
 * - `model`: another mesh is open, or, without a name and files, that of the model was refined or refining was
 *   undone. `positions` is one of the two buffers.
 * - `document`: after every edit and every load.
 * - `scene`: the scene file's text with its steps of undo, whenever it changed and the solver rests: what
 *   is saved, and what a dead worker is replaced with. `progress`: now and then, how far a run or a drag
 *   has come since then.
 * - `frame`: a state of the iteration. `values` are those of `measure`, `#F`;
 *   `corners` those of the vertices, `#V`, whose largest the faces have, where they are of vertices;
 *   `shapes` the fitted shapes, eight numbers each;
 *   `projections` where the constraints would have their vertices; `answers` the time of the newest
 *   move of a drag that it shows, and the milliseconds since that came.
 * - `activity`: whether the solver runs (Run was pressed and it has not converged); sent after the
 *   frame that belongs to it.
 * - `collapsed`: the run has ended with a shape that has collapsed, and how. `converged` is not said of it.
 * - `experiment`: what an experiment has measured since the last one. `ended` is null while it goes on;
 *   `message` says why it failed.
 * - `trouble`: an iteration failed; the last good state stays.
 * - `died`: the state is unusable, the worker must be replaced.
 * - `working`: it begins with what may take a while, and says nothing until then. `pong`: it lives.
 * - `refused`: `path` is the place in the scene that is wrong, such as `constraints[0].length`; empty
 *   when it is not about a scene.
 * @typedef {{ type: "ready", kinds: KindInfo[], elements: ElementInfo[], measures: FaceMeasure[],
 *       operations: Operation[], settings: SettingInfo[] }
 *   | { type: "loading", bytes: number, all: number }
 *   | { type: "model", loaded: Loaded, connectivity: Connectivity, positions: Float64Array }
 *   | { type: "document", document: SceneDocument }
 *   | { type: "scene", text: string, history: Uint8Array, iteration: number }
 *   | { type: "progress", bytes: Uint8Array, iteration: number }
 *   | { type: "frame", numbers: Numbers, positions: Float64Array,
 *       measure: Measure | null, values: Float32Array | null, corners: Float32Array | null,
 *       shapes: Float32Array | null, projections: Projections | null,
 *       answers: [number, number] | null }
 *   | { type: "activity", running: boolean, converged: boolean }
 *   | { type: "collapsed", collapse: string }
 *   | { type: "experiment", news: ExperimentNews[], ended: "done" | "cancelled" | "failed" | null, message: string }
 *   | { type: "trouble", message: string }
 *   | { type: "died", message: string }
 *   | { type: "working" }
 *   | { type: "pong" }
 *   | { type: "reply", id: number, value: unknown }
 *   | { type: "refused", id: number, message: string, path: string }} FromWorker
 */

/** The messages of the worker by their type. @typedef {{ [T in FromWorker["type"]]: Extract<FromWorker, { type: T }> }} WorkerEvents */

/**
 * What answers each request: one that is missing, that is none, or whose value is not what the request is
 * answered with is an error of types.
 * @typedef {{ [T in Request["type"]]: (message: Extract<Request, { type: T }>) => Replies[T] | Promise<Replies[T]> }} RequestHandlers
 */
/** What does each command. @typedef {{ [T in Command["type"]]: (message: Extract<Command, { type: T }>) => void }} CommandHandlers */

/** How long the worker iterates before it looks for messages, in milliseconds. */
export const SLICE_MS = 8;

/** Numbers per iteration in the answer to `trace`. */
export const TRACE_WIDTH = 6;

/**
 * What the worker for files of Rhino is asked, once: to read one, as the mesh in it, or to write a scene
 * with the table of the errors of its faces, or what is built.
 * @typedef {{ type: "read", file: NamedBytes } | { type: "write", scene: string, errors: string }
 *   | { type: "writeParts", parts: SpatialPart[], symbol: string }} RhinoRequest
 * @typedef {{ read: NamedBytes, write: Uint8Array<ArrayBuffer>, writeParts: Uint8Array<ArrayBuffer> }} RhinoReplies
 * @typedef {{ value: RhinoReplies[keyof RhinoReplies] } | { refused: string }} RhinoAnswer
 */

/** All of them: a scene has those that are not the default. @typedef {Required<import("../pkg/build/shape_up.js").BuildSettings>} BuildSettings */
/** @typedef {import("../pkg/build/shape_up.js").BuildPreset} BuildPreset */
/** @typedef {import("../pkg/build/shape_up.js").BuildReport} BuildReport */
/** @typedef {import("../pkg/build/shape_up.js").BuildCard} BuildCard */
/** @typedef {import("../pkg/build/shape_up.js").CheckRow} CheckRow */
/** @typedef {import("../pkg/build/shape_up.js").Choice} BuildChoice */
/** @typedef {import("../pkg/build/shape_up.js").SheetPicture} SheetPicture */
/** @typedef {import("../pkg/build/shape_up.js").SpatialPart} SpatialPart */
/** @typedef {import("../pkg/build/shape_up.js").BuildNumber} BuildNumber */
/** @typedef {import("../pkg/build/shape_up.js").ReportPage} ReportPage */

/**
 * The offset as the view shows it: its points `#V by 3`, edges (two vertices each), vertices and panels that are
 * not within a limit.
 * @typedef {{ points: Float64Array, edges: Uint32Array, vertices: Uint32Array, panels: Uint32Array }} OffsetLayer
 */

/**
 * What the worker that makes parts is asked. `build` makes them of a shape (positions `#V by 3`) in a unit of so
 * many metres, and draws so many `sheets` at most; the others are about what was built last. `moveLayer` gives its
 * offset another distance, and `reshape` makes that of other positions, while somebody moves something; `reportPage` has a picture as a camera sees it that is turned and tilted by two angles in radians, or as
 * one sees a mesh first.
 * @typedef {{ type: "offers" } | { type: "choices" } | { type: "numbers" } | { type: "zip", zUp: boolean } | { type: "spatialParts", zUp: boolean } | { type: "moveLayer", distance: number }
 *   | { type: "reshape", positions: Float64Array }
 *   | { type: "reportPage", title: string, zUp: boolean, camera: Float64Array | null, link: string }
 *   | { type: "build", positions: Float64Array, offsets: Uint32Array, indices: Uint32Array,
 *       settings: BuildSettings, symbol: string, metres: number, sheets: number }} BuildRequest
 * @typedef {object} BuildReplies
 * @property {{ presets: BuildPreset[], defaults: BuildSettings }} offers
 * @property {{ report: BuildReport, sheets: SheetPicture[], layer: OffsetLayer }} build
 * @property {{ report: BuildCard, layer: OffsetLayer } | null} moveLayer
 * @property {{ report: BuildCard, layer: OffsetLayer } | null} reshape
 * @property {BuildChoice[]} choices
 * @property {[string, number][]} numbers that a lesson may bound, by id
 * @property {ReportPage | null} reportPage
 * @property {SpatialPart[]} spatialParts
 * @property {Uint8Array<ArrayBuffer>} zip
 */

/**
 * One line for whatever was thrown.
 * @param {unknown} thrown
 * @returns {string}
 */
export function messageOf(thrown) {
  const hasMessage = thrown && typeof thrown === 'object' && 'message' in thrown;
  const message = String(hasMessage ? thrown.message : thrown);
  // In the words of browsers and of what bundles the page.
  return /preload CSS|imported module|importing a module|HTTP status code|Failed to fetch|NetworkError when|^Load failed/i.test(
    message,
  )
    ? 'A part of the page could not be fetched. Check the network.'
    : message;
}
