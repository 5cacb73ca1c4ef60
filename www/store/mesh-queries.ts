/**
 * Selection by properties of the mesh: the solver declares and performs the operations; this module
 * applies their results. The status line shows the size of every new selection.
 */

import { combineOf, describe, select, sizeOfSelection, type Combine } from './selection.ts';
import type { Operation, ParamValue } from '../pkg/engine/shape_up.js';
import type { Mode, Selection, Store } from './state.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Actions } from './actions.ts';
import type { Command } from '../app/context.ts';

/**
 * Parameters of an operation, how its result is combined with the selection, where it starts from in
 * place of the selection, and an element that the result must contain.
 */
interface How {
  params?: Record<string, ParamValue>;
  combine?: Combine;
  from?: Partial<Record<Mode, Iterable<number>>>;
  including?: number;
}

const MODES: Mode[] = ['vertices', 'edges', 'faces'];

export class Selecting {
  #store;
  #solver;
  #actions;
  /** The operation of the last double-click, and what it selected, of which all since then is a part. */
  #last: { operation: Operation; selection: Selection } | null = null;

  constructor(store: Store, solver: SolverClient, actions: Actions) {
    this.#store = store;
    this.#solver = solver;
    this.#actions = actions;
    store.subscribe(['model', 'selection'], ({ selection }) => {
      if (!this.#last || !isWithin(selection, this.#last.selection)) this.#last = null;
    });
    this.#announce();
  }

  /** Whether an operation is applicable now. */
  canApply({ modes, needsSelection }: Operation) {
    const { mode, selection } = this.#store.get();
    return modes.includes(mode) && (!needsSelection || sizeOfSelection(selection) > 0);
  }

  /**
   * Selects with an operation. One that starts from the selection replaces it; the others may also
   * add to it or remove from it.
   * @returns rejects with an error in the parameters
   */
  apply(operation: Operation, how: How = {}): Promise<boolean> {
    return this.#solver.begin(this.#apply(operation, how));
  }

  async #apply(
    operation: Operation,
    { params = {}, combine = 'replace', from, including }: How,
  ): Promise<boolean> {
    const { model } = this.#store.get();
    // The selection before may not be there yet.
    await this.#solver.settled();
    const { mode, selection, model: now } = this.#store.get();
    // An element to start from is one of the mesh before.
    if (from && now !== model) return false;
    const lists = Object.entries(from ?? selection).map(([name, items]) => [name, [...items]]);
    const found = await this.#solver.ask.select({
      operation: operation.id,
      mode,
      from: Object.fromEntries(lists),
      params,
    });
    const state = this.#store.get();
    // What the user has selected meanwhile stays.
    const isReplaced = combine === 'replace' && state.selection !== selection;
    if (state.model !== now || isReplaced) return false;
    const gives = MODES.find((one) => found[one].length > 0);
    if (including !== undefined && !(gives && found[gives].includes(including))) return false;
    if (!gives) {
      this.#actions.setStatus(`${operation.label}: nothing found`);
      return false;
    }
    const next = select(state.selection, gives, found[gives], combine);
    this.#store.set({ mode: gives, selection: next });
    return true;
  }

  /** As {@link apply}, but reports errors in an alert. */
  async applyOrReport(...asked: Parameters<Selecting['apply']>) {
    return (await this.#actions.reportErrors(this.apply(...asked))) ?? false;
  }

  /** Performs the operation of a double-click on an element, if any. */
  doubleClick(mode: Mode, item: number, event: MouseEvent) {
    const { operations, adds } = this.#store.get();
    const withShift = operations.find(({ shiftDoubleClick }) => shiftDoubleClick === mode);
    const plain = operations.find(({ doubleClick }) => doubleClick === mode);
    const isOther = event.shiftKey && withShift;
    const operation = isOther ? withShift : plain;
    if (!operation) return;
    const isAgain = this.#last?.operation === operation && this.#last.selection[mode].has(item);
    this.#store.set({ mode });
    const combine = isOther ? 'replace' : combineOf(event, adds);
    const how: How = { from: { [mode]: [item] }, combine };
    const wider = isAgain ? operations.find(({ id }) => id === operation.again) : undefined;
    void this.#select(operation, wider, how, item);
  }

  /** Applies the wider operation if its result contains the item, else the operation. */
  async #select(operation: Operation, wider: Operation | undefined, how: How, item: number) {
    const { model } = this.#store.get();
    const isWider = wider && (await this.applyOrReport(wider, { ...how, including: item }));
    const goesOn = !isWider && this.#store.get().model === model;
    const isDone = goesOn && (await this.applyOrReport(operation, how));
    const { selection } = this.#store.get();
    this.#last = isDone && how.combine === 'replace' ? { operation, selection } : null;
  }

  /** Adds the operations with keys to the commands, once the solver has declared them. */
  bindKeys(commands: Command[]) {
    let bound = false;
    this.#store.subscribe(['operations'], ({ operations }) => {
      if (bound || operations.length === 0) return;
      bound = true;
      for (const operation of operations.filter(isCommand)) {
        const { id, label, keys } = operation;
        commands.push({
          id: `select-${id}`,
          group: 'Select',
          label: `Selection: ${label.toLowerCase()}`,
          keys,
          // Such as a ring more of faces.
          repeats: operation.needsSelection,
          action: () => this.applyOrReport(operation),
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

/** Whether something is selected, and nothing that another selection has not. */
const isWithin = (selection: Selection, other: Selection) =>
  sizeOfSelection(selection) > 0 &&
  MODES.every((mode) => [...selection[mode]].every((item) => other[mode].has(item)));

/** Whether an operation can be a command: one that asks for something has a form instead. */
const isCommand = ({ keys, params, takesName }: Operation) =>
  keys.length > 0 || (params.length === 0 && !takesName);
