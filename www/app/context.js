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
 * @property {import("../ui/controls/alerts.js").Alerts} alerts
 * @property {import("../features/hold-original.js").HoldOriginal} hold
 */

/**
 * @typedef {object} Actors what only commands act on
 * @property {import("../viewport/input/pointer.js").PointerInput} pointer
 * @property {() => void} lesson opens the dialog that writes one
 * @property {() => void} share shows a link to the scene
 * @property {() => void} flatMap shows the flat map, or takes it away
 * @property {() => void} split shows two pictures, or one again
 * @property {HTMLInputElement} fileInput
 * @property {() => Promise<void>} help
 */
/** @typedef {AppContext & Actors} CommandContext */

export {};
