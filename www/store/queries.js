/** Questions to the solver, which change nothing. Each rejects with what the solver says, or reports it. */

/** @typedef {import("../solver/messages.js").Measure} Measure */
/** @typedef {"errors" | "convergence" | "angles"} Table */

/**
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {<T>(promise: Promise<T>) => Promise<T | undefined>} reportErrors
 */
export function createQueries(solver, reportErrors) {
  /** The shape that was opened. @type {Promise<Float64Array> | null} */
  let original = null;
  solver.on('model', () => (original = null));

  return {
    /** What a constraint acts on; reports. @param {import("../solver/messages.js").ConstraintRow} row */
    members: ({ index }) => reportErrors(solver.request({ type: 'members', constraint: index })),

    /** The elements that a problem of the mesh is about. @param {string} flaw */
    flawed: (flaw) => solver.request({ type: 'flawed', flaw }),

    /**
     * The worst elements by a measure, or of a constraint.
     * @param {{ measure: Measure | null, row: number | null }} about
     * @param {number} count
     */
    worst: (about, count) => solver.request({ type: 'worst', ...about, count }),

    /** Elements by what the mesh is like. @param {import("../solver/messages.js").SelectRequest} request */
    find: (request) => solver.request({ type: 'select', request }),

    /** What each kind would make at these places. @param {import("../solver/messages.js").Selector[]} places */
    previews: (places) => reportErrors(solver.request({ type: 'previews', places })),

    /** Corners of faces by their angles, originally and now; reports. */
    angles: () => reportErrors(solver.request({ type: 'angles' })),

    /** The energies of each iteration. */
    trace: () => solver.request({ type: 'trace' }),

    /** How far the mesh will move for panels of one shape, in words. */
    forecast: () => solver.request({ type: 'forecast' }),

    /** How many panels are within the tolerance. @param {number} tolerance */
    verdict: (tolerance) => solver.request({ type: 'verdict', tolerance }),

    /** Changes that would bring the worst constraint nearer. */
    remedies: () => solver.request({ type: 'remedies' }),

    /** Where the vertices were when the model was opened, `#V by 3`: asked once. */
    originalPositions: () =>
      (original ??= solver.request({ type: 'originalPositions' }).catch((error) => {
        original = null;
        throw error;
      })),

    /**
     * Values of the faces.
     * @param {Measure} measure
     * @param {boolean} original those that it had when opened
     * @param {number} [variant] those of a shape that was kept
     */
    faceValues: (measure, original, variant) =>
      solver.request({ type: 'faceValues', measure, original, variant }),

    /** Values of the vertices, where the measure has any. @param {Measure} measure */
    cornerValues: (measure) => solver.request({ type: 'cornerValues', measure }),

    /**
     * A flat map of the shape as it is.
     * @param {import("../solver/messages.js").MapWeights} weights
     * @param {import("../solver/messages.js").MapNorm} norm
     */
    parametrize: (weights, norm) => solver.request({ type: 'parametrize', weights, norm }),

    /**
     * The settings of the flat map that turns fewest triangles over; null where none turns fewer than `flipped`.
     * @param {number} flipped
     */
    fewerFlips: (flipped) => solver.request({ type: 'fewerFlips', flipped }),

    /** A table as CSV. @param {Table} table */
    table: (table) => solver.request({ type: 'table', table }),

    /** The shape as OBJ: with a flat map, or in the vertices of the file. @param {{ uv?: Float64Array, asItCame?: boolean }} how */
    obj: (how) => solver.request({ type: 'obj', ...how }),

    /** How many faces it can work with while somebody watches. */
    mostFaces: () => solver.request({ type: 'mostFaces' }),

    /** The files that a scene among these names and that are not there. @param {import("../solver/messages.js").NamedBytes[]} files */
    missingFiles: (files) => solver.request({ type: 'missingFiles', files }),

    /** The text of the scene. */
    sceneText: () => solver.request({ type: 'scene' }),

    /** What the comparison of methods on whatever is open declares. */
    comparison: () => solver.request({ type: 'comparison' }),

    /**
     * Runs the methods of an experiment one after another; their samples come as events.
     * @param {Extract<import("../solver/messages.js").Request, { type: "runExperiment" }>["of"]} of
     * @param {number} iterations at most
     */
    runExperiment: (of, iterations) => solver.request({ type: 'runExperiment', of, iterations }),

    cancelExperiment: () => solver.send({ type: 'cancelExperiment' }),

    /** The samples of the experiment that ran last, as CSV. */
    experimentCsv: () => solver.request({ type: 'experimentCsv' }),

    /** The numbers of what is built that a lesson may bound. */
    buildNumbers: () => solver.request({ type: 'buildNumbers' }),

    /**
     * Tells the session numbers of what is built of the shape, which goals of a lesson may be on.
     * @param {[string, number][]} numbers by id
     */
    tellBuild: (numbers) =>
      solver.request({
        type: 'tellBuild',
        ids: numbers.map(([id]) => id),
        values: Float64Array.from(numbers, ([, value]) => value),
      }),

    /** What is handed in of a lesson. @param {string} student @param {string} time */
    results: (student, time) => solver.request({ type: 'results', student, time }),
  };
}
