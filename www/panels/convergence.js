/**
 * The energies of every iteration since the model was opened or reset, drawn while they are in sight.
 * The plotting library comes with the first iteration, not with the page.
 */

import { element, throttled } from '../dom.js';
import { TRACE_WIDTH, messageOf } from '../messages.js';
import { energyOrNothing } from '../rounding.js';

/** @typedef {import("../plot.js").EnergyPlot} EnergyPlot */
/** @typedef {import("../messages.js").Numbers} Numbers */

/** A plot of thousands of iterations takes some milliseconds. */
const PLOT_EVERY_MS = 250;

export class Convergence {
  /** Columns: iteration, shape, close, smooth, handles, total. @type {number[][]} */
  #columns = emptyColumns();
  /** @type {Promise<EnergyPlot> | null} */
  #plot = null;
  #place;
  #store;
  #draw;
  #inSight = false;

  /**
   * @param {HTMLElement} place
   * @param {import("../state.js").Store} store
   * @param {import("../solver-client.js").SolverClient} solver
   */
  constructor(place, store, solver) {
    this.#place = place;
    this.#store = store;
    this.#draw = throttled(PLOT_EVERY_MS, () => this.#drawNow());
    this.#empty();
    new IntersectionObserver(([entry]) => {
      this.#inSight = entry.isIntersecting;
      if (this.#inSight) this.#draw();
    }).observe(place);
    solver.addEventListener('model', () => this.#empty());
    solver.addEventListener('frame', (event) => {
      const { numbers, trace } = /** @type {CustomEvent} */ (event).detail;
      this.#add(trace);
      // Undo and reset go back: what came after is no longer so.
      this.#forgetAfter(numbers.iteration);
      this.#correctLast(numbers);
    });
    store.subscribe(['dark'], () => this.#plot?.then((plot) => plot.restyle()));
  }

  /** @param {Float64Array} trace */
  #add(trace) {
    for (let at = 0; at < trace.length; at += TRACE_WIDTH) {
      this.#forgetAfter(trace[at] - 1);
      const [iterations, ...energies] = this.#columns;
      iterations.push(trace[at]);
      energies.forEach((column, i) => column.push(this.#energy(trace[at + 1 + i])));
    }
    if (trace.length > 0) this.#draw();
  }

  /** @param {number} iteration */
  #forgetAfter(iteration) {
    const [iterations] = this.#columns;
    if (iterations.length === 0 || iterations[iterations.length - 1] <= iteration) return;
    const keep = iterations.findIndex((value) => value > iteration);
    this.#columns.forEach((column) => column.splice(keep));
    this.#draw();
  }

  /** An edit changes the energies of the iteration that it was made at. @param {Numbers} numbers */
  #correctLast({ iteration, energy }) {
    const [iterations, ...energies] = this.#columns;
    if (iterations.at(-1) !== iteration) return;
    const { shape, close, smooth, handles, total } = energy;
    [shape, close, smooth, handles, total].forEach((value, i) => {
      energies[i][iterations.length - 1] = this.#energy(value);
    });
  }

  /** As it is shown. @param {number} value */
  #energy(value) {
    return energyOrNothing(value, this.#store.get().size);
  }

  #empty() {
    this.#columns = emptyColumns();
    this.#showNone();
  }

  /** No plot: there is no iteration, or none any more. */
  #showNone() {
    this.#plot?.then((plot) => plot.destroy());
    this.#plot = null;
    this.#place.replaceChildren(
      element('p', { class: 'quiet' }, 'The energies of each iteration appear here.'),
    );
  }

  async #drawNow() {
    if (!this.#inSight) return;
    if (this.#columns[0].length < 2) return this.#showNone();
    this.#plot ??= this.#load();
    const { document } = this.#store.get();
    const units = document?.units ? `${document.units}²` : '';
    (await this.#plot.catch(() => null))?.show(this.#columns, units);
  }

  async #load() {
    try {
      const { EnergyPlot } = await import('../plot.js');
      this.#place.replaceChildren();
      return new EnergyPlot(this.#place);
    } catch (error) {
      this.#place.replaceChildren(
        element('p', {}, `The plot could not be loaded: ${messageOf(error)}`),
      );
      throw error;
    }
  }
}

/** @returns {number[][]} */
function emptyColumns() {
  return Array.from({ length: TRACE_WIDTH }, () => []);
}
