/** Queries to the solver, which change nothing. They reject on errors, or report them. */

/** @typedef {import("../solver/messages.js").Measure} Measure */
/** @typedef {"errors" | "convergence" | "angles"} Table */

/**
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {<T>(promise: Promise<T>) => Promise<T | undefined>} reportErrors
 */
export function createQueries(solver, reportErrors) {
  /** Positions of the original. @type {Promise<Float64Array> | null} */
  let original = null;
  solver.on('model', () => (original = null));

  return {
    /**
     * Returns the elements on which a constraint acts; reports errors.
     * @param {import("../solver/messages.js").ConstraintRow} row
     */
    members: ({ index }) => reportErrors(solver.request({ type: 'members', constraint: index })),

    /** Returns the elements affected by a problem of the mesh. @param {string} flaw */
    flawed: (flaw) => solver.request({ type: 'flawed', flaw }),

    /**
     * Returns the worst elements by a measure, or of a constraint row.
     * @param {{ measure: Measure | null, row: number | null }} about
     * @param {number} count
     */
    worst: (about, count) => solver.request({ type: 'worst', ...about, count }),

    /** Finds elements. @param {import("../solver/messages.js").SelectRequest} request */
    find: (request) => solver.request({ type: 'select', request }),

    /**
     * Previews each kind of constraint at each selector; reports errors.
     * @param {import("../solver/messages.js").Selector[]} places
     */
    previews: (places) => reportErrors(solver.request({ type: 'previews', places })),

    /** Returns the angles of face corners, originally and now; reports errors. */
    angles: () => reportErrors(solver.request({ type: 'angles' })),

    /** Returns a mesh or a scene of the examples. @param {string} name of the file */
    exampleFile: (name) => solver.request({ type: 'exampleFile', name }),

    /** The energies of each iteration. */
    trace: () => solver.request({ type: 'trace' }),

    /** Estimates how far the mesh will move to make all panels of one kind, as a sentence. */
    forecast: () => solver.request({ type: 'forecast' }),

    /** Returns how many panels are within the tolerance. @param {number} tolerance */
    verdict: (tolerance) => solver.request({ type: 'verdict', tolerance }),

    /** Returns changes that would reduce the worst constraint distance. */
    remedies: () => solver.request({ type: 'remedies' }),

    /** Returns the positions at opening, `#V by 3`; requested once. */
    originalPositions: () =>
      (original ??= solver.request({ type: 'originalPositions' }).catch((error) => {
        original = null;
        throw error;
      })),

    /**
     * Returns values of the faces.
     * @param {Measure} measure
     * @param {boolean} original whether to return those at opening
     * @param {number} [variant] index of a kept shape
     */
    faceValues: (measure, original, variant) =>
      solver.request({ type: 'faceValues', measure, original, variant }),

    /** Returns values of the vertices, if the measure has any. @param {Measure} measure */
    cornerValues: (measure) => solver.request({ type: 'cornerValues', measure }),

    /**
     * Returns a flat map of the current shape.
     * @param {import("../solver/messages.js").MapWeights} weights
     * @param {import("../solver/messages.js").MapNorm} norm
     */
    parametrize: (weights, norm) => solver.request({ type: 'parametrize', weights, norm }),

    /**
     * Returns the map settings with the fewest flips; null if none has fewer than `flipped`.
     * @param {number} flipped
     */
    fewerFlips: (flipped) => solver.request({ type: 'fewerFlips', flipped }),

    /** Returns a table as CSV. @param {Table} table */
    table: (table) => solver.request({ type: 'table', table }),

    /**
     * Returns the shape as OBJ: with a flat map, or with the file's original vertices.
     * @param {{ uv?: Float64Array, unwelded?: boolean }} how
     */
    obj: (how) => solver.request({ type: 'obj', ...how }),

    /** Returns the number of faces up to which this computer stays interactive. */
    mostFaces: () => solver.request({ type: 'mostFaces' }),

    /**
     * Returns the files that a scene among these names and that are missing.
     * @param {import("../solver/messages.js").NamedBytes[]} files
     */
    missingFiles: (files) => solver.request({ type: 'missingFiles', files }),

    sceneText: () => solver.request({ type: 'scene' }),

    /** Returns the declaration of the comparison of methods on the current model. */
    comparison: () => solver.request({ type: 'comparison' }),

    /**
     * Runs the methods of an experiment one after another; their samples arrive as events.
     * @param {Extract<import("../solver/messages.js").Request, { type: "runExperiment" }>["of"]} of
     * @param {number} iterations at most
     */
    runExperiment: (of, iterations) => solver.request({ type: 'runExperiment', of, iterations }),

    cancelExperiment: () => solver.send({ type: 'cancelExperiment' }),

    /** Returns the samples of the last experiment as CSV. */
    experimentCsv: () => solver.request({ type: 'experimentCsv' }),

    /** Returns the fabrication numbers that a lesson may bound. */
    buildNumbers: () => solver.request({ type: 'buildNumbers' }),

    /**
     * Passes fabrication numbers of the shape to the session; goals of a lesson may refer to them.
     * @param {[string, number][]} numbers by id
     */
    setBuildNumbers: (numbers) =>
      solver.request({
        type: 'setBuildNumbers',
        ids: numbers.map(([id]) => id),
        values: Float64Array.from(numbers, ([, value]) => value),
      }),

    /** Returns the submission of a lesson. @param {string} student @param {string} time */
    results: (student, time) => solver.request({ type: 'results', student, time }),
  };
}
