/**
 * The energies of the iterations since the model was opened or reset, plotted while visible. The
 * plotting library is loaded with the first iteration, not with the page.
 */

import { element, throttled } from '../ui/dom.ts';
import { messageOf } from '../solver/errors.ts';
import { energyOrZero } from '../ui/rounding.ts';
import type { EnergyPlot } from '../ui/plot/plot.ts';
import type { AppContext } from '../app/context.ts';

/** Numbers per iteration in a trace. */
const TRACE_WIDTH = 6;

/**
 * The least interval between redraws: a plot of thousands of iterations takes some milliseconds.
 */
const PLOT_EVERY_MS = 250;

export class Convergence {
  /** Null without iterations; of null if it could not be loaded. */
  #plot: Promise<EnergyPlot | null> | null = null;
  #place;
  #store;
  #actions;
  #draw;
  #inSight = false;

  constructor(place: HTMLElement, { store, solver, actions }: AppContext) {
    this.#place = place;
    this.#store = store;
    this.#actions = actions;
    this.#draw = throttled(PLOT_EVERY_MS, () => this.#drawNow());
    this.#showNone();
    new IntersectionObserver(([entry]) => {
      this.#inSight = entry.isIntersecting;
      if (this.#inSight) this.#draw();
    }).observe(place);
    solver.on('model', () => this.#showNone());
    solver.on('frame', () => this.#draw());
    store.subscribe(['dark'], () => this.#plot?.then((plot) => plot?.restyle()));
  }

  /** Removes the plot: there are no iterations. */
  #showNone() {
    void this.#plot?.then((plot) => plot?.destroy());
    this.#plot = null;
    this.#place.replaceChildren(element('p.quiet', 'The energies of each iteration appear here.'));
  }

  async #drawNow() {
    if (!this.#inSight || !this.#store.get().model) return;
    // A stopped solver reports its own error.
    const trace = await this.#actions.ask.trace().catch(() => null);
    if (!trace) return;
    if (trace.length < 2 * TRACE_WIDTH) return this.#showNone();
    const loading = (this.#plot ??= this.#load());
    const { document } = this.#store.get();
    const units = document?.units ? `${document.units}²` : '';
    const plot = await loading;
    // Another model may be open by now.
    if (loading === this.#plot) plot?.show(this.#columnsOf(trace), units);
  }

  /** Returns columns: iteration, shape, close, smooth, handles, total; rounding errors as zero. */
  #columnsOf(trace: Float64Array) {
    const size = this.#store.get().model?.size ?? 0;
    const rows = trace.length / TRACE_WIDTH;
    return Array.from({ length: TRACE_WIDTH }, (_, column) =>
      Array.from({ length: rows }, (_, row) => {
        const value = trace[row * TRACE_WIDTH + column];
        return column === 0 ? value : energyOrZero(value, size);
      }),
    );
  }

  async #load() {
    try {
      const { EnergyPlot } = await import('../ui/plot/plot.ts');
      this.#place.replaceChildren();
      return new EnergyPlot(this.#place);
    } catch (error) {
      this.#place.replaceChildren(
        element('p', `The plot could not be loaded: ${messageOf(error)}`),
      );
      return null;
    }
  }
}
