/**
 * What the solver declares, once, in `ready`: everything that the page needs to make its controls for
 * kinds, elements, measures, ways to select and settings. Rust says what is in each.
 */

/** @typedef {import("../pkg/solver/shape_up.js").ElementWords} ElementInfo */
/** @typedef {import("../pkg/solver/shape_up.js").FaceMeasure} FaceMeasure */
/** @typedef {import("../pkg/solver/shape_up.js").Form} Form */
/** @typedef {import("../pkg/solver/shape_up.js").KindWords} KindInfo */
/** @typedef {import("../pkg/solver/shape_up.js").Mode} PickMode */
/** @typedef {import("../pkg/solver/shape_up.js").Operation} Operation */
/** @typedef {import("../pkg/solver/shape_up.js").Param} ParamInfo */
/** @typedef {import("../pkg/solver/shape_up.js").ParamValue} ParamValue */
/** @typedef {import("../pkg/solver/shape_up.js").Setting} SettingInfo */
/** @typedef {import("../pkg/solver/shape_up.js").Sketch} Sketch */

/** The id of a {@link FaceMeasure}. @typedef {string} Measure */

export {};
