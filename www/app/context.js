/**
 * Types of the objects that `main.js` passes to the other folders. There is no code here, so every
 * folder may import them.
 */

/**
 * @typedef {object} Command
 * @property {string} id value of `data-command`
 * @property {string} group heading in the help
 * @property {string} label in the help
 * @property {string[]} keys such as "Ctrl+Shift+Z"; letters are the characters printed on the keys
 * @property {() => unknown} action may load its implementation
 * @property {boolean} [needsModel] whether a press waits until the first model is loaded
 * @property {(state: import("../store/state.js").State) => boolean} [enabled] always, if absent
 * @property {(state: import("../store/state.js").State) => boolean} [pressed] for toggle buttons
 * @property {(state: import("../store/state.js").State) => string} [title] tooltip, else the label
 */

/**
 * @typedef {object} AppContext objects shared by the parts of the page
 * @property {import("../store/state.js").Store} store
 * @property {import("../solver/solver-client.js").SolverClient} solver
 * @property {import("../viewport/viewport.js").Viewport} viewport
 * @property {import("../documents/files.js").Files} files
 * @property {import("../store/actions.js").Actions} actions
 * @property {import("../store/mesh-queries.js").Selecting} selecting
 * @property {import("../ui/controls/alerts.js").Alerts} alerts
 * @property {import("../features/hold-original.js").HoldOriginal} hold
 * @property {(choices: [import("../store/view-modes.js").Choice, import("../store/view-modes.js").Choice]) => Promise<void>} showSides splits the view into left and right
 * @property {ReturnType<typeof import("./script-api.js").scriptApi>} script the API for scripts
 * @property {Command[]} commands commands of selection operations are added later
 */

/**
 * Declaration of a folder of `features/` or `panels/`, exported by its `feature.js`.
 * @typedef {object} Feature
 * @property {(app: AppContext) => Command[]} [commands]
 * @property {Part[]} [parts] each is loaded when it is first needed
 */

/**
 * @typedef {object} Part
 * @property {(keyof import("../store/state.js").State)[]} keys the state that `isNeeded` depends on
 * @property {(state: Readonly<import("../store/state.js").State>) => boolean} isNeeded
 * @property {(app: AppContext) => Promise<unknown>} load
 */

export {};
