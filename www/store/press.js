/** Execution of commands from buttons, keys and menus, and whether they are enabled. */

/** @typedef {import("../app/context.js").Command} Command */
/** @typedef {import("./state.js").State} State */
/** @typedef {import("./state.js").Store} Store */

/** Commands given before there was a model. @type {Set<Command>} */
const waiting = new Set();

/** @type {(command: Command, state: State) => boolean} */
export const isEnabled = ({ enabled }, state) => !enabled || enabled(state);

/**
 * Executes a command if it is enabled, now or as soon as there is a model.
 * @param {Command} command
 * @param {Store} store
 */
export function press(command, store) {
  const state = store.get();
  if (command.needsModel && !state.document) {
    if (waiting.size === 0) store.set({ status: 'Starts when the model is loaded' });
    waiting.add(command);
  } else if (isEnabled(command, state)) {
    command.action();
  }
}

/**
 * Executes commands given before this script was loaded, and later those that wait for the model.
 * @param {Command[]} commands
 * @param {Store} store
 * @param {string[]} early names of commands
 */
export function runEarlyPresses(commands, store, early) {
  for (const name of early) {
    const command = commands.find(({ id }) => id === name);
    if (command) press(command, store);
  }
  store.subscribe(['document'], ({ document }) => {
    if (!document) return;
    const pressed = [...waiting];
    waiting.clear();
    pressed.forEach((command) => press(command, store));
  });
}
