/**
 * Variations of the open shape that keep it exact: a search in the second worker, and the shape of
 * their sliders.
 */

import { signal } from '@preact/signals';
import { messageOf, retryIfCollateral } from '../../solver/errors.ts';
import { latestOnly } from '../../store/latest-only.ts';
import { isHard } from '../../store/state.ts';
import type { Connectivity } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

const NONE = 'Not all required constraints are satisfied yet. Press Run first.';
const NOTHING = 'Variations keep what is required, and nothing is required now.';
const HINT = 'Move the sliders; their effects add up. The line under each shows how far it can go.';

/** Slider steps from the middle to either end. */
export const STEPS = 100;

export interface Variation {
  /** the shape that is varied, `#V by 3` */
  shape: Float64Array;
  connectivity: Connectivity;
  /** per unit of the coefficient, `#V by 3` */
  displacements: Float32Array;
  /** maximum absolute value of the coefficient */
  slide: number;
}

export class Variations {
  /** What is being done, or what can be. */
  readonly words = signal('');
  readonly found = signal<Variation[]>([]);
  /** The feasible range of each, as far as it is known. */
  readonly ranges = signal<(number[] | null)[]>([]);
  /** The positions of the sliders, in steps from the middle. */
  readonly steps = signal<number[]>([]);
  /** Whether what is shown is exact, so that it can be kept. */
  readonly isExact = signal(false);
  #app;
  /** Number of the current search; a new number ends it. */
  #search = 0;
  /** What the last action shows: the shape of the sliders, that made exact, or the shape before. */
  #wanted: 'moved' | 'exact' | 'none' = 'none';
  /** The document for which the variations were computed. */
  #searched: unknown = null;
  /** The generation of the shape that is varied, and of the worker that has its variations. */
  #varied = { generation: 0, worker: 0 };
  #updates = latestOnly(() =>
    this.#app.actions.reportErrors(retryIfCollateral(() => this.#follow())),
  );

  constructor(app: AppContext) {
    this.#app = app;
  }

  /**
   * Searches, and again when the shape changes, until the returned function is called.
   * @param end is called when there is nothing to vary
   */
  begin(end: () => void) {
    const { store, jobs } = this.#app;
    let isOn = true;
    const stop = store.subscribe(['document', 'running', 'model'], (state) => {
      const { document: scene, running, model } = state;
      // Not at once: what ends the subscription is returned only after the first call.
      if (!model?.faces || !scene) queueMicrotask(() => isOn && end());
      // An edit or undo step may have changed the shape, and with it the variations.
      else if (!running && scene !== this.#searched) void this.#find();
    });
    return () => {
      isOn = false;
      stop();
      this.#search++;
      // An update that waits would ask the copy.
      this.#wanted = 'none';
      if (this.isMoved()) this.leave();
      if (this.#searched && this.#varied.worker === jobs.generation)
        void jobs
          .of('variations')
          .ask.free()
          .catch(() => {});
    };
  }

  isMoved() {
    return this.steps.value.some((step) => step !== 0);
  }

  /** While a slider moves: shows the deformed shape. */
  move(index: number, step: number) {
    this.steps.value = this.steps.value.with(index, step);
    this.#show('moved');
  }

  /** After a slider is released: makes the shape exact. */
  release() {
    this.#show('exact');
  }

  /** Returns to the shape without variation. */
  leave() {
    this.steps.value = this.steps.value.map(() => 0);
    this.#show('none');
  }

  async keep() {
    const { actions } = this.#app;
    this.isExact.value = false;
    const done = await actions.variations.keep();
    if (done) actions.setStatus('Kept. You continue from this shape.');
    else this.isExact.value = true;
  }

  /** Shows what is wanted; during an update, after it. */
  #show(wanted: 'moved' | 'exact' | 'none') {
    this.#wanted = wanted;
    this.isExact.value = false;
    void this.#updates.ask();
  }

  async #follow(): Promise<unknown> {
    const { actions, jobs } = this.#app;
    const { variations } = actions;
    if (this.#wanted === 'none') return variations.leave();
    if (this.#varied.worker !== jobs.generation) {
      // The worker that had the variations was ended. The search waits for updates, so not for it here.
      void this.#find();
      return null;
    }
    if (this.#wanted === 'exact') return this.#project();
    const shape = await jobs.of('variations').ask.towards(this.#coefficients());
    // A variation that is shown is what Undo takes back: in the middle there is none.
    if (!this.isMoved()) return variations.leave();
    return variations.show(this.#varied.generation, shape, null);
  }

  #coefficients() {
    const found = this.found.value;
    return Float64Array.from(this.steps.value, (step, k) => (found[k].slide * step) / STEPS);
  }

  async #project() {
    const { actions, jobs } = this.#app;
    const { variations } = actions;
    const asked = this.steps.value;
    const { positions, part, report } = await jobs.of('variations').ask.go(this.#coefficients());
    const isShown = await variations.show(this.#varied.generation, positions, report);
    if (!isShown || this.#updates.hasNext()) return;
    if (part < 1) this.steps.value = asked.map((step) => Math.round(part * step));
    this.words.value =
      part < 1 ? 'Farther, the required constraints could not all be satisfied.' : HINT;
    if (!this.isMoved()) return variations.leave();
    this.isExact.value = true;
  }

  /** Computes the variations of the open shape. */
  async #find() {
    const mine = ++this.#search;
    try {
      await retryIfCollateral(() => this.#findIn(mine));
    } catch (error) {
      if (mine === this.#search) this.words.value = messageOf(error);
    }
  }

  /** @param mine the number of the search */
  async #findIn(mine: number) {
    const { store, solver, jobs, actions } = this.#app;
    const { ask, copy } = jobs.of('variations');
    const { connectivity } = solver.geometry ?? {};
    const isCurrent = () => mine === this.#search;
    this.found.value = this.ranges.value = this.steps.value = [];
    this.words.value = 'Looking for variations of the shape …';
    this.#searched = store.get().document;
    await actions.variations.leave();
    const model = await actions.atRest();
    // A run has begun meanwhile: its end begins another search.
    if (!model || !isCurrent()) return;
    if (!connectivity || !(await copy(model).findVariations())) {
      const isRequired = store.get().document?.constraints.some(isHard);
      if (isCurrent()) this.words.value = isRequired ? NONE : NOTHING;
      return;
    }
    if (!isCurrent()) return;
    this.#varied = { generation: model.generation, worker: jobs.generation };
    let progress = await ask.advanceVariations();
    while (isCurrent() && progress.found === null) progress = await ask.advanceVariations();
    if (!isCurrent()) return;
    const shape = solver.geometry?.positions.slice() ?? new Float64Array(0);
    const { slide } = progress;
    for (let index = 0; index < (progress.found ?? 0); index++) {
      const displacements = await ask.variation(index);
      if (!isCurrent()) return;
      this.steps.value = [...this.steps.value, 0];
      this.found.value = [...this.found.value, { shape, connectivity, displacements, slide }];
    }
    this.words.value =
      this.found.value.length > 0
        ? HINT
        : 'No other shape nearby satisfies all required constraints.';
    while (isCurrent()) {
      this.ranges.value = progress.ranges;
      if (!progress.more) break;
      // Slider moves take priority.
      while (this.#updates.isBusy() && isCurrent())
        await new Promise((resolve) => setTimeout(resolve, 50));
      if (isCurrent()) progress = await ask.advanceVariations();
    }
  }
}
