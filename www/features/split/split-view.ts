/**
 * The split view: fetches the values of both sides and owns the divider and the two legends, in
 * which the user selects what each side shows. Loaded on first use.
 */

import { closeButton } from '../../ui/controls/fields.ts';
import { byId } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import { declared, measureOfScene, roundingOf, toleranceOf } from '../../store/colours/measures.ts';
import { latestOnly } from '../../store/latest-only.ts';
import { splitDivider } from './split-divider.ts';
import { SplitLegend } from './split-legend.ts';
import { greatestOf } from '../../ui/plot/histogram.ts';
import './split.css';
import type { Choice, Split } from '../../store/view-modes.ts';
import type { AppContext } from '../../app/context.ts';

/** Minimum colour range in multiples of the rounding error; finer ones cannot be built or seen. */
const LEAST_RANGE = 1000;

export class SplitView {
  #store;
  #solver;
  #actions;
  #legends;
  /** Left and right. */
  #choices: [Choice, Choice] | null = null;
  /** Values of the original, by measure. */
  #originalValues: Map<string, Float32Array> = new Map();
  /** Upper ends of the ranges, by measure: the same on both sides. */
  #tops: Map<string, number> = new Map();
  #updates = latestOnly(async () => {
    if (this.#store.get().split) await this.#actions.reportErrors(this.#fetch());
  });

  /** The only instance of the page. */
  static of = once((app: AppContext) => new SplitView(app));

  constructor(app: AppContext) {
    const { store, solver, viewport, actions } = app;
    this.#store = store;
    this.#solver = solver;
    this.#actions = actions;
    this.#legends = ['Left', 'Right'].map(
      (name, i) => new SplitLegend(name, i, store, viewport, (choice) => this.#choose(i, choice)),
    );
    const divider = splitDivider(app, () => this.#choices?.map((choice) => this.#words(choice)));
    this.#legends[1].element.firstElementChild?.append(
      closeButton(
        'Close the split view',
        () => actions.look({ split: null, status: 'Split view closed' }),
        { title: 'Close the split view (Esc)' },
      ),
    );
    byId('legend').after(divider, ...this.#legends.map((legend) => legend.element));
    store.subscribe(['split', 'measures', 'document', 'dark', 'display'], (state) => {
      this.#legends.forEach((legend, i) => {
        const side = state.split?.sides[i];
        legend.show(side, this.#originalValues.get(side?.measure ?? ''));
      });
    });
    store.subscribe(['flatMap'], ({ flatMap }) => {
      if (flatMap) actions.look({ split: null });
    });
    store.subscribe(['display', 'tolerance', 'tolerances'], () => this.#update());
    solver.on('frame', () => this.#update());
    solver.on('model', () => {
      this.#choices = null;
      this.#originalValues.clear();
      this.#tops.clear();
    });
    // An edit may change the requirements on faces, and so the original's values.
    solver.on('document', () => {
      this.#originalValues.clear();
      this.#dropLostVariants();
    });
  }

  /** @param choices left and right; default: last, or original and current */
  async open(choices?: [Choice, Choice]) {
    const state = this.#store.get();
    const measure = state.measure ?? measureOfScene(state) ?? state.measures[0].id;
    this.#choices = choices ??
      this.#choices ?? [
        { measure, original: true },
        { measure, original: false },
      ];
    this.#tops.clear();
    this.#actions.look({ flatMap: null });
    await this.#fetch();
    this.#actions.setStatus(
      `Left: ${this.#words(this.#choices[0])}; right: ${this.#words(this.#choices[1])}`,
    );
  }

  #words({ measure, original, variant }: Choice) {
    const label = declared(this.#store.get(), measure)?.label ?? measure;
    return `${label}, ${variant?.name ?? (original ? 'original' : 'now')}`;
  }

  /** @param which side */
  #choose(which: number, choice: Partial<Choice>) {
    if (!this.#choices) return;
    const changed = this.#choices.map((old, i) => (i === which ? { ...old, ...choice } : old));
    this.#choices = changed as [Choice, Choice];
    this.#update();
  }

  /** Shows the current shape on a side whose kept shape was removed or renamed. */
  #dropLostVariants() {
    const names = this.#store.get().document?.variants ?? [];
    this.#choices?.forEach(({ variant }, i) => {
      if (variant && names[variant.index] !== variant.name) this.#choose(i, { variant: undefined });
    });
  }

  /** Updates both sides; during an update, once more after it. */
  #update() {
    if (this.#store.get().split) void this.#updates.ask();
  }

  async #fetch() {
    const { model } = this.#store.get();
    const choices = this.#choices;
    if (!choices) return;
    const wasOpen = this.#store.get().split !== null;
    const original = await this.#actions.originalPositions();
    const [values, corners] = await Promise.all([
      Promise.all(choices.map((choice) => this.#valuesOf(choice))),
      Promise.all(choices.map((choice) => this.#cornersOf(choice))),
    ]);
    const { split, model: now } = this.#store.get();
    // Another model was opened, or the split view was closed.
    if (now !== model || choices !== this.#choices || (wasOpen && !split)) return;
    choices.forEach(({ measure }, i) => this.#extendRange(measure, values[i]));
    const sides = choices.map((choice, i) => {
      const side = {
        ...choice,
        positions: choice.variant?.positions ?? (choice.original ? original : undefined),
        values: values[i],
        corners: corners[i],
        low: this.#lowOf(choice.measure),
        top: this.#tops.get(choice.measure) ?? 1,
        tolerance: this.#toleranceOf(choice.measure),
      };
      const before = split?.sides[i];
      const keys = Object.keys(side) as (keyof typeof side)[];
      return before && keys.every((key) => before[key] === side[key]) ? before : side;
    });
    this.#actions.look({
      split: { at: split?.at ?? 0.5, sides: sides as Split['sides'] },
    });
  }

  async #valuesOf({ measure, original, variant }: Choice) {
    if (variant) {
      return this.#actions.faceValues(measure, false, variant.index);
    }
    const known = this.#originalValues.get(measure);
    const before = known ?? (await this.#actions.faceValues(measure, true));
    this.#originalValues.set(measure, before);
    this.#extendRange(measure, before);
    if (original) return before;
    const { geometry } = this.#solver;
    if (geometry?.measure === measure && geometry.values) return geometry.values;
    return this.#actions.faceValues(measure, false);
  }

  /** Returns corner values for colour bands; undefined for the original, with one band per face. */
  async #cornersOf({ measure, original, variant }: Choice) {
    if (original || variant || !this.#store.get().display.bands) return undefined;
    const { geometry } = this.#solver;
    if (geometry?.measure === measure && geometry.corners) return geometry.corners;
    return (await this.#actions.cornerValues(measure)) ?? undefined;
  }

  /** Extends the range of a measure to include these values. */
  #extendRange(measure: string, values: Float32Array) {
    const state = this.#store.get();
    const about = declared(state, measure);
    const least = about ? LEAST_RANGE * roundingOf(about, state.size) : 0;
    const twice = 2 * (this.#toleranceOf(measure) ?? 0);
    const before = this.#tops.get(measure) ?? Math.max(least, twice);
    this.#tops.set(measure, Math.max(before, greatestOf(values)));
  }

  /** Lower end of the colour range: `-top` for a signed measure. */
  #lowOf(measure: string) {
    const top = this.#tops.get(measure) ?? 1;
    return declared(this.#store.get(), measure)?.signed ? -top : (this.#toleranceOf(measure) ?? 0);
  }

  /** Up to this value faces keep the material colour; null if all values are coloured. */
  #toleranceOf(measure: string) {
    const state = this.#store.get();
    const about = declared(state, measure);
    return about && !state.display.full ? toleranceOf(state, about) : null;
  }
}
