/**
 * The types of what `main.js` gives to the rooms below. Only types: nothing here runs, so every room may
 * name them.
 */

/**
 * @typedef {object} Command
 * @property {string} id what `data-command` names
 * @property {string} group heading in the help
 * @property {string} label in the help
 * @property {string[]} keys such as "Ctrl+Shift+Z"; letters are what is written on the key
 * @property {() => void} action
 * @property {boolean} [needsModel] while the first model is on its way, a press waits for it
 * @property {(state: import("../store/state.js").State) => boolean} [enabled] always, when absent
 * @property {(state: import("../store/state.js").State) => boolean} [pressed] for buttons that are toggles
 * @property {(state: import("../store/state.js").State) => string} [title] instead of the label
 */

/**
 * @typedef {object} AppContext what the parts of the page may use
 * @property {import("../store/state.js").Store} store
 * @property {import("../solver/solver-client.js").SolverClient} solver
 * @property {import("../viewport/viewport.js").Viewport} viewport
 * @property {import("../documents/files.js").Files} files
 * @property {import("../store/actions.js").Actions} actions
 * @property {import("../store/mesh-queries.js").Selecting} selecting
 * @property {import("../ui/controls/alerts.js").Alerts} alerts
 * @property {import("../features/hold-original.js").HoldOriginal} hold
 * @property {(choices: [import("../store/view-modes.js").Choice, import("../store/view-modes.js").Choice]) => Promise<void>} showSides two pictures, left and right
 * @property {ReturnType<typeof import("./script-api.js").scriptApi>} script the page for scripts
 * @property {Command[]} commands those that operations of selecting declare come later
 */

/**
 * What a folder of `features/` or `panels/` says of itself in its `feature.js`.
 * @typedef {object} Feature
 * @property {(app: AppContext) => Command[]} [commands]
 * @property {Part[]} [parts] each comes when it is first needed
 */

/**
 * @typedef {object} Part
 * @property {(keyof import("../store/state.js").State)[]} keys what decides whether it is needed
 * @property {(state: Readonly<import("../store/state.js").State>) => boolean} isNeeded
 * @property {(app: AppContext) => Promise<unknown>} load
 */

export {};
