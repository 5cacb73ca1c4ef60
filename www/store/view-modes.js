/** What can be seen in place of the plain picture: the flat map beside the model, and two pictures. */

/**
 * What a surface shows: the squares of the map, or the colours of the quasi-conformal error.
 * @typedef {"checks" | "errors"} Look
 */

/**
 * @typedef {object} FlatMap
 * @property {import("../solver/messages.js").Parametrization} found
 * @property {import("../solver/messages.js").MapWeights} weights that it was made with
 * @property {import("../solver/messages.js").MapNorm} norm that it was made with
 * @property {number} iteration of the shape that was flattened
 * @property {import("../solver/messages.js").FewerFlips | "searching" | "none" | null} fewer settings that turn fewer triangles over; null where nobody has looked
 * @property {Look} onModel
 * @property {Look} onMap
 * @property {number} squares along the longer side of the map
 */

/**
 * What a side shows: the original, the current shape, or one that was kept, coloured by a measure.
 * @typedef {{ measure: import("../solver/messages.js").Measure, original: boolean, variant?: KeptShape }} Choice
 */

/**
 * A shape that was kept.
 * @typedef {{ index: number, name: string, positions: Float64Array }} KeptShape
 */

/**
 * @typedef {object} Shown what the view needs of a side
 * @property {Float64Array | undefined} positions of the original, where it is shown
 * @property {Float32Array | undefined} values of the faces
 * @property {Float32Array | undefined} corners values of the vertices whose greatest those are, for bands
 * @property {number} low of the range of the colours: its beginning
 * @property {number} top of the range of the colours
 * @property {number | null} tolerance where the range begins: up to it the faces keep the material
 */

/**
 * @typedef {object} Split
 * @property {number} at where the divider is, from 0 to 1
 * @property {[(Choice & Shown), (Choice & Shown)]} sides left and right; a side that changes is another object
 */

export {};
