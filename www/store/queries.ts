/** Queries to the solver, which change nothing. They reject on errors, or report them. */

import type {
  ConstraintRow,
  MapNorm,
  MapWeights,
  Measure,
  NamedBytes,
  SelectRequest,
  Selector,
} from '../solver/messages.ts';
import type { SolverClient } from '../solver/solver-client.ts';

type Table = 'errors' | 'convergence' | 'angles';

export function createQueries(
  solver: SolverClient,
  reportErrors: <T>(promise: Promise<T>) => Promise<T | undefined>,
) {
  /** Positions of the original. */
  let original: Promise<Float64Array> | null = null;
  solver.on('model', () => (original = null));

  return {
    /** Returns the elements on which a constraint acts; reports errors. */
    members: ({ index }: ConstraintRow) =>
      reportErrors(solver.request({ type: 'members', constraint: index })),

    /** Returns the elements affected by a problem of the mesh. */
    flawed: (flaw: string) => solver.request({ type: 'flawed', flaw }),

    /** Returns the worst elements by a measure, or of a constraint row. */
    worst: (about: { measure: Measure | null; row: number | null }, count: number) =>
      solver.request({ type: 'worst', ...about, count }),

    /** Finds elements. */
    find: (request: SelectRequest) => solver.request({ type: 'select', request }),

    /** Previews each kind of constraint at each selector; reports errors. */
    previews: (places: Selector[]) => reportErrors(solver.request({ type: 'previews', places })),

    /** Returns the angles of face corners, originally and now; reports errors. */
    angles: () => reportErrors(solver.request({ type: 'angles' })),

    /**
     * Returns a mesh or a scene of the examples.
     * @param name of the file
     */
    exampleFile: (name: string) => solver.request({ type: 'exampleFile', name }),

    /** The energies of each iteration. */
    trace: () => solver.request({ type: 'trace' }),

    /** Estimates how far the mesh will move to make all panels of one kind, as a sentence. */
    forecast: () => solver.request({ type: 'forecast' }),

    /** Returns how many panels are within the tolerance. */
    verdict: (tolerance: number) => solver.request({ type: 'verdict', tolerance }),

    /** Returns changes that would reduce the worst constraint distance. */
    remedies: () => solver.request({ type: 'remedies' }),

    /** Returns the positions at opening, `#V by 3`; requested once. */
    originalPositions: () =>
      (original ??= solver.request({ type: 'originalPositions' }).catch((error) => {
        original = null;
        throw error;
      })),

    /** Returns the values of the faces at opening. */
    originalValues: (measure: Measure) => solver.request({ type: 'originalValues', measure }),

    /** Returns a flat map of the current shape. */
    parametrize: (weights: MapWeights, norm: MapNorm) =>
      solver.request({ type: 'parametrize', weights, norm }),

    /** Returns the map settings with the fewest flips; null if none has fewer than `flipped`. */
    fewerFlips: (flipped: number) => solver.request({ type: 'fewerFlips', flipped }),

    /** Returns a table as CSV. */
    table: (table: Table) => solver.request({ type: 'table', table }),

    /** Returns the shape as OBJ: with a flat map, or with the file's original vertices. */
    obj: (how: { uv?: Float64Array; unwelded?: boolean }) =>
      solver.request({ type: 'obj', ...how }),

    /** Returns the number of faces up to which this computer stays interactive. */
    mostFaces: () => solver.request({ type: 'mostFaces' }),

    /** Returns the files that a scene among these names and that are missing. */
    missingFiles: (files: NamedBytes[]) => solver.request({ type: 'missingFiles', files }),

    sceneText: () => solver.request({ type: 'scene' }),

    /** Returns the fabrication numbers that a lesson may bound. */
    buildNumbers: () => solver.request({ type: 'buildNumbers' }),

    /**
     * Passes fabrication numbers of the shape to the session; goals of a lesson may refer to them.
     * @param numbers by id
     */
    setBuildNumbers: (numbers: [string, number][]) =>
      solver.request({
        type: 'setBuildNumbers',
        ids: numbers.map(([id]) => id),
        values: Float64Array.from(numbers, ([, value]) => value),
      }),

    /** Returns the submission of a lesson. */
    results: (student: string, time: string) => solver.request({ type: 'results', student, time }),
  };
}
