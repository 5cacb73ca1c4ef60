/** Questions to the solver, which change nothing. Those without a note say themselves what went wrong. */

/**
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {<T>(promise: Promise<T>) => Promise<T | undefined>} reportErrors
 */
export function createQueries(solver, reportErrors) {
  return {
    /** What a constraint acts on. @param {import("../solver/messages.js").ConstraintRow} row */
    members: ({ index }) => reportErrors(solver.request({ type: 'members', constraint: index })),

    /** The elements that a problem of the file is about. @param {string} flaw */
    flawed: (flaw) => reportErrors(solver.request({ type: 'flawed', flaw })),

    /**
     * The worst elements by a measure, or of a constraint.
     * @param {{ measure: import("../solver/messages.js").Measure | null, row: number | null }} about
     * @param {number} count
     */
    worst: (about, count) => reportErrors(solver.request({ type: 'worst', ...about, count })),

    /** Corners of faces by their angles, originally and now. */
    angles: () => reportErrors(solver.request({ type: 'angles' })),

    /** The energies of each iteration; null of a solver that has stopped, which says so itself. */
    trace: () => solver.request({ type: 'trace' }).catch(() => null),

    /** A table as CSV; rejects. @param {"errors" | "convergence" | "angles"} table */
    table: (table) => solver.request({ type: 'table', table }),
  };
}
