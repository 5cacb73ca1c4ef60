/**
 * Selecting by what the mesh is like: the solver declares the ways to do it and answers them; here
 * is what the page does with an answer. How many are selected is said after every change.
 */

import { combineOf, describe, select, sizeOfSelection } from './selection.js';

/** @typedef {import("../solver/messages.js").Operation} Operation */
/** @typedef {import("../solver/messages.js").ParamValue} ParamValue */
/** @typedef {import("./selection.js").Combine} Combine */
/** @typedef {import("./state.js").Mode} Mode */

/** @type {Mode[]} */
const MODES = ['vertices', 'edges', 'faces'];

export class Selecting {
  #store;
  #solver;
  #actions;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("../solver/solver-client.js").SolverClient} solver
   * @param {import("./actions.js").Actions} actions
   */
  constructor(store, solver, actions) {
    this.#store = store;
    this.#solver = solver;
    this.#actions = actions;
    this.#announce();
  }

  /** Whether a way to select has a meaning now. @param {Operation} operation */
  canApply({ modes, needsSelection }) {
    const { mode, selection } = this.#store.get();
    return modes.includes(mode) && (!needsSelection || sizeOfSelection(selection) > 0);
  }

  /**
   * Selects with an operation. What starts from the selection replaces it; the others may also add
   * to it or take away from it.
   * @param {Operation} operation
   * @param {object} [options]
   * @param {Record<string, ParamValue>} [options.params]
   * @param {Combine} [options.combine]
   * @param {Partial<Record<Mode, Iterable<number>>>} [options.from] instead of what is selected
   * @returns {Promise<boolean>} rejects with what is wrong with the parameters
   */
  async apply(operation, { params = {}, combine = 'replace', from } = {}) {
    const { mode, selection, model } = this.#store.get();
    const lists = Object.entries(from ?? selection).map(([name, items]) => [name, [...items]]);
    const found = await this.#solver.request({
      type: 'select',
      request: { operation: operation.id, mode, from: Object.fromEntries(lists), params },
    });
    // Somebody opened another model meanwhile.
    if (this.#store.get().model !== model) return false;
    const gives = MODES.find((one) => found[one].length > 0);
    if (!gives) {
      this.#actions.setStatus(`${operation.label}: nothing found`);
      return false;
    }
    const now = this.#store.get().selection;
    this.#store.set({ mode: gives, selection: select(now, gives, found[gives], combine) });
    return true;
  }

  /** As {@link apply}, for what has no fields to show an error at. @type {Selecting["apply"]} */
  async applyOrTell(operation, options) {
    return (await this.#actions.reportErrors(this.apply(operation, options))) ?? false;
  }

  /**
   * What a double-click on an element does, if anything.
   * @param {Mode} mode
   * @param {number} item
   * @param {MouseEvent} event
   */
  doubleClick(mode, item, event) {
    const { operations } = this.#store.get();
    const operation = operations.find(({ doubleClick }) => doubleClick === mode);
    if (!operation) return;
    this.#store.set({ mode });
    this.applyOrTell(operation, { from: { [mode]: [item] }, combine: combineOf(event) });
  }

  /**
   * The keys that operations declare, once they are here, as commands.
   * @param {import("../app/context.js").Command[]} commands
   */
  bindKeys(commands) {
    let bound = false;
    this.#store.subscribe(['operations'], ({ operations }) => {
      if (bound || operations.length === 0) return;
      bound = true;
      for (const operation of operations.filter(({ keys }) => keys.length > 0)) {
        const { id, label, keys } = operation;
        commands.push({
          id: `select-${id}`,
          group: 'Select',
          label: `Selection: ${label.toLowerCase()}`,
          keys,
          action: () => this.applyOrTell(operation),
          needsModel: true,
          enabled: () => this.canApply(operation),
        });
      }
    });
  }

  #announce() {
    let { selection, model } = this.#store.get();
    this.#store.subscribe(['selection', 'model'], (state) => {
      const before = selection;
      const isNew = state.model !== model;
      ({ selection, model } = state);
      if (isNew || before === selection) return;
      if (sizeOfSelection(before) + sizeOfSelection(selection) === 0) return;
      const words = describe(selection);
      this.#actions.setStatus(words ? `${words} selected` : 'Nothing selected');
    });
  }
}
