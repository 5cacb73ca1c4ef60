/**
 * What the solver declares, once, in `ready`: everything that the page needs to make its controls for
 * kinds, elements, measures, ways to select and settings.
 */

/**
 * A declared operator: everything that the page shows of a kind.
 * @typedef {object} KindInfo
 * @property {string} id
 * @property {string} label
 * @property {string} summary one sentence
 * @property {string} paper where the paper defines it
 * @property {boolean} exact
 * @property {string} takes how many vertices or edges, in words
 * @property {Measure | null} measure of faces that says how far this kind is from being met on them
 * @property {string | null} panels what panels are that have it ("flat"), of kinds that are offered for all of them
 * @property {string[]} elements ids of those that it is meant for; empty where any will do
 * @property {[number, number, number]} colour sRGB bytes
 * @property {ParamInfo[]} params
 * @property {Sketch} sketch
 */

/**
 * A declared parameter of a kind.
 * @typedef {object} ParamInfo
 * @property {string} id
 * @property {string} label
 * @property {"length" | "area" | "volume" | "degrees" | ""} unit
 * @property {ParamValue} default
 * @property {Form[]} forms what a value may be, the form of the default among it
 * @property {[number, number]} range least and greatest number, also at the ends of a range
 */

/** @typedef {"number" | "range" | "vector" | "nothing" | { word: string }} Form */

/**
 * A value in one of these forms: a number, from and to (null for no limit), a direction, a word, or
 * null for whatever fits best.
 * @typedef {number | [number | null, number | null] | [number, number, number] | string | null} ParamValue
 */

/**
 * What a kind does to a few points, drawn in the unit square, y downwards: the points as they are,
 * as they become, which of them are joined, and closed curves of the fitted shapes.
 * @typedef {{ points: [number, number][], projected: [number, number][], lines: [number, number][], outlines: [number, number][][] }} Sketch
 */

/**
 * Elements of a mesh that can carry one constraint each.
 * @typedef {{ id: string, label: string, faceBased: boolean }} ElementInfo
 */

/**
 * A declared way to select. `gives` is what it gives where that is not what is picked.
 * @typedef {object} Operation
 * @property {string} id
 * @property {string} label
 * @property {string} summary one sentence
 * @property {string} group the heading that it is listed under
 * @property {PickMode[]} modes
 * @property {PickMode | null} gives
 * @property {boolean} needsSelection
 * @property {boolean} takesName of a set or group, as the parameter `name`
 * @property {ParamInfo[]} params
 * @property {string[]} keys
 * @property {PickMode | null} doubleClick
 */

/** @typedef {"vertices" | "edges" | "faces"} PickMode */

/** A declared setting of a scene: as a parameter, with one sentence and a heading. @typedef {ParamInfo & { summary: string, group: string }} SettingInfo */

/** The id of a {@link FaceMeasure}. @typedef {string} Measure */

/**
 * A declared measure of faces: never negative, and 0 is best.
 * @typedef {object} FaceMeasure
 * @property {Measure} id
 * @property {string} label
 * @property {string} words what is measured
 * @property {string} met what is true where the values of all faces are 0
 * @property {"length" | "percent" | "degrees" | "number"} unit
 * @property {boolean} toleranced whether the tolerance of the model applies to it
 */

export {};
