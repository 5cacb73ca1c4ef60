/** Execution of commands from buttons, keys and menus, and whether they are enabled. */

import type { AppContext, Command } from '../app/context.ts';
import type { State, Store } from './state.ts';

/** Status while something waits for a model. */
export const STARTS_LATER = 'Starts when the model is loaded';

/** Commands given before there was a model. */
const waiting: Set<Command> = new Set();

export const isEnabled: (command: Command, state: State) => boolean = ({ enabled }, state) =>
  !enabled || enabled(state);

/**
 * Executes a command if it is enabled, now or as soon as there is a model.
 * @param settled resolves when the page shows the edits begun before, which may enable the command
 */
export function perform(command: Command, store: Store, settled?: () => Promise<void>) {
  const state = store.get();
  if (command.needsModel && !state.document) {
    if (waiting.size === 0) store.set({ status: STARTS_LATER });
    waiting.add(command);
  } else if (isEnabled(command, state)) {
    command.action();
  } else if (settled) {
    void settled().then(() => perform(command, store));
  }
}

/** Executes the command of this name. */
export function performNamed(
  id: string,
  { commands, store }: Pick<AppContext, 'commands' | 'store'>,
) {
  const command = commands.find((one) => one.id === id);
  if (command) perform(command, store);
}

/**
 * Executes commands given before this script was loaded, and later those that wait for the model.
 * @param early names of commands
 */
export function runEarlyPresses(commands: Command[], store: Store, early: string[]) {
  for (const name of early) {
    const command = commands.find(({ id }) => id === name);
    if (command) perform(command, store);
  }
  store.subscribe(['document'], ({ document }) => {
    if (!document) return;
    const pressed = [...waiting];
    waiting.clear();
    pressed.forEach((command) => perform(command, store));
  });
}
