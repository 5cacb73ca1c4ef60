/** Display modes besides the plain picture: the flat map beside the model, and a split view. */

/**
 * Content of a surface: the checkerboard of the map, or the colours of the quasi-conformal error.
 * @typedef {"checks" | "errors"} Look
 */

/**
 * @typedef {object} FlatMap
 * @property {import("../solver/messages.js").Parametrization} found
 * @property {import("../solver/messages.js").MapWeights} weights of the computation
 * @property {import("../solver/messages.js").MapNorm} norm of the computation
 * @property {number} iteration of the shape that was flattened
 * @property {import("../solver/messages.js").FewerFlips | "searching" | "none" | null} fewerFlips
 *   settings with fewer flipped triangles; null if not searched
 * @property {Look} onModel
 * @property {Look} onMap
 * @property {number} squares number of squares along the longer side of the map
 */

/**
 * Content of a side: the original, the current shape or a kept one, coloured by a measure.
 * @typedef {{ measure: import("../solver/messages.js").Measure, original: boolean, variant?: KeptShape }} Choice
 */

/**
 * A kept shape.
 * @typedef {{ index: number, name: string, positions: Float64Array }} KeptShape
 */

/**
 * @typedef {object} Shown data of a side for the view
 * @property {Float64Array | undefined} positions of the original, if that is shown
 * @property {Float32Array | undefined} values of the faces
 * @property {Float32Array | undefined} corners values of the vertices, for bands (maximum per face)
 * @property {number} low beginning of the range of the colours
 * @property {number} top end of the range of the colours
 * @property {number | null} tolerance beginning of the range, up to which faces keep their material
 */

/**
 * @typedef {object} Split
 * @property {number} at position of the divider, from 0 to 1
 * @property {[(Choice & Shown), (Choice & Shown)]} sides left and right; new objects when they change
 */

export {};
