/**
 * Types of the solver's declarations, which it sends once in `ready`: all data from which the page
 * makes its controls for kinds, elements, measures, selections, settings. Rust defines the fields.
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
