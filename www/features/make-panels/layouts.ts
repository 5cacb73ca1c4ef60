/**
 * Layouts of new panels along the lines of curvature, in the second worker: one after another for the
 * newest settings of the user, drawn over the mesh.
 */

import { effect, signal } from '@preact/signals';
import { Cancelled, refusalOf } from '../../solver/errors.ts';
import { latestOnly } from '../../store/latest-only.ts';
import type { AppContext } from '../../app/context.ts';
import type { State } from '../../store/state.ts';
import type {
  BoundaryForecast,
  LaidOut,
  LayoutNote,
  LayoutSettings,
  RefusedAt,
} from '../../pkg/engine/shape_up.js';

type Fields = Required<Pick<LayoutSettings, 'count' | 'size'>>;

/** What the user asks for. */
interface LayoutRequest extends Fields, Pick<LayoutSettings, 'follow' | 'even'> {
  boundary: BoundaryForecast['boundary'] | null;
  /** whether the selected faces stay as they are */
  keeps: boolean;
}

/** Initial positions of the sliders, from 0 to 1. */
const AT_FIRST: LayoutRequest = {
  ...{ count: null, size: null, boundary: null, keeps: false },
  follow: 2 / 3,
  even: 0.25,
};

/** Panels with what they were asked for, and the generation of the model. */
interface LaidOutFor {
  panels: LaidOut;
  asked: LayoutRequest;
  generation: number;
}

/** What the second worker does for the layouts. */
export const LAYING_OUT = ['layOutPanels', 'panelsAtBoundaries'] as const;

/** Time without another request after which both choices at the boundary are forecast. */
const IDLE_MS = 1000;

/** The faces that can stay as they are: those that are selected, unless all are. */
export const selectedFaces = ({ selection, model }: Pick<State, 'selection' | 'model'>) =>
  selection.faces.size === model?.faces ? [] : [...selection.faces];

export class Layouts {
  readonly settings = signal(AT_FIRST);
  /** Number and side in their fields: what was typed, or what came of it. */
  readonly fields = signal<Fields>({ count: null, size: null });
  readonly laidOut = signal<LaidOutFor | null>(null);
  readonly said = signal<{ words: string; notes: LayoutNote[] }>({ words: '', notes: [] });
  /** What is being done, which can be cancelled; null if nothing is. */
  readonly doing = signal<string | null>(null);
  /** Both choices at the boundary, once they are known; empty if they were not to be found. */
  readonly forecast = signal<BoundaryForecast[] | null>(null);
  #app;
  #close;
  /** The place of a refusal. */
  #refused = signal<RefusedAt | null>(null);
  #layouts = latestOnly(() => this.#layOut());
  /** The layout under way. */
  #laying: Promise<unknown> = Promise.resolve();
  /** The number of layouts that were begun. */
  #turn = 0;
  #isForecasting = false;
  /** Whether panels were removed, and none are laid out in their place yet. */
  #isWithdrawn = false;
  #isOpen = false;

  /** @param close leaves the layouts: another model was opened, or the first one was cancelled */
  constructor(app: AppContext, close: () => void) {
    this.#app = app;
    this.#close = close;
  }

  /** Lays out and draws, until the returned function is called. */
  begin() {
    const { store, solver, jobs, viewport } = this.#app;
    const { model: about, document } = store.get();
    let units = document?.units;
    let { faces } = store.get().selection;
    this.#isOpen = true;
    const stops = [
      this.#draws(),
      jobs.on('told', ({ words }) => {
        if (this.#layouts.isBusy()) this.doing.value = words;
      }),
      store.subscribe(['model', 'document'], ({ model, document: now }) => {
        if (model !== about) return this.#close();
        // The words have lengths.
        if (!now || now.units === units) return;
        ({ units } = now);
        this.#update();
      }),
      store.subscribe(['selection'], ({ selection }) => {
        if (selection.faces === faces) return;
        ({ faces } = selection);
        if (this.settings.value.keeps) this.#update();
      }),
      solver.on('frame', ({ generation }) => {
        const laidOut = this.laidOut.value;
        if (laidOut && laidOut.generation !== generation) this.#withdraw();
        // The shape is back, as after a variation that was only shown.
        else if (this.#isWithdrawn && generation === solver.copy()?.generation) this.#update();
      }),
      // The solver is idle again, after a change.
      solver.on('scene', ({ generation }) => {
        if (this.laidOut.value?.generation !== generation) this.#update();
      }),
      viewport.on('ready', () => this.#draw()),
    ];
    this.#update();
    return () => {
      this.#isOpen = false;
      stops.forEach((stop) => stop());
      // The second worker is free for the next question.
      if (this.#layouts.isBusy() || this.#isForecasting) this.cancel();
    };
  }

  change(own: Partial<LayoutRequest>) {
    this.settings.value = { ...this.settings.value, ...own };
    // Both forecasts stay for the choice between them.
    if (!('boundary' in own)) this.forecast.value = null;
    const { count, size } = this.fields.value;
    this.fields.value = { count: own.count ?? count, size: own.size ?? size };
    this.#ask();
  }

  cancel() {
    this.#app.jobs.cancel(...LAYING_OUT);
  }

  /**
   * Puts the panels in place of the mesh.
   * @returns whether this was done
   */
  async use() {
    const { mesh, actions } = this.#app;
    // A number that was typed last.
    await this.#laying;
    const laidOut = this.laidOut.value;
    if (!laidOut || !this.#isOpen) return false;
    const { panels, generation } = laidOut;
    const taken = await actions.reportErrors(mesh.takePanels(generation, panels));
    if (taken === false) this.#update();
    // The new model has ended the layouts.
    return taken ?? false;
  }

  #update() {
    this.#isWithdrawn = false;
    this.forecast.value = null;
    this.#ask();
  }

  #ask() {
    if (this.#layouts.isBusy()) void this.#layouts.ask();
    else this.#laying = this.#layouts.ask();
  }

  async #layOut() {
    const { store, solver, jobs } = this.#app;
    const model = solver.copy();
    if (!this.#isOpen || !model) return;
    this.#turn += 1;
    this.doing.value = 'Laying out panels …';
    const asked = this.settings.value;
    const { keeps, ...settings } = asked;
    const kept = Uint32Array.from(keeps ? selectedFaces(store.get()) : []);
    try {
      const panels = await jobs.copy(model).layOutPanels(settings, kept);
      // Another request, or another shape, has come meanwhile.
      if (!this.#isOpen || this.#layouts.hasNext()) return;
      this.#refused.value = null;
      this.#show({ panels, asked, generation: model.generation });
      if (panels.boundary)
        void this.#forecastBoundaries(() => jobs.copy(model).panelsAtBoundaries(settings, kept));
    } catch (error) {
      if (this.#isOpen) await this.#refuse(error, () => jobs.copy(model).panelsRefusedAt());
    } finally {
      if (!this.#layouts.hasNext()) this.doing.value = null;
    }
  }

  /** @param place asks where */
  async #refuse(error: unknown, place: () => Promise<RefusedAt | undefined>) {
    const before = this.laidOut.value;
    if (error instanceof Cancelled) {
      if (!before) return this.#close();
      this.settings.value = before.asked;
      return this.#show(before);
    }
    const refused = (await place().catch(() => null)) ?? null;
    if (this.#layouts.hasNext()) return;
    this.laidOut.value = this.forecast.value = null;
    this.#refused.value = refused;
    const words = refusalOf(error, 'Not possible');
    this.said.value = refused
      ? { words: '', notes: [{ words, places: [Array.from(refused.vertices)] }] }
      : { words, notes: [] };
  }

  #show(laidOut: LaidOutFor) {
    const { words, notes, count, size } = laidOut.panels;
    this.laidOut.value = laidOut;
    this.said.value = { words, notes };
    this.fields.value = { count, size };
  }

  /** Forecasts both choices at the boundary, unless another request comes first. */
  async #forecastBoundaries(ask: () => Promise<BoundaryForecast[]>) {
    const mine = this.#turn;
    await new Promise((later) => setTimeout(later, IDLE_MS));
    if (!this.#isOpen || mine !== this.#turn) return;
    this.#isForecasting = true;
    this.doing.value = 'Comparing both choices at the boundary …';
    const found = await ask().catch(() => []);
    this.#isForecasting = false;
    if (!this.#layouts.isBusy()) this.doing.value = null;
    if (this.#isOpen && mine === this.#turn) this.forecast.value = found;
  }

  /** Removes panels that are for another shape. */
  #withdraw() {
    this.#isWithdrawn = true;
    this.laidOut.value = null;
    this.said.value = { words: 'The shape has changed …', notes: [] };
  }

  /** Draws over the mesh, whose own edges are hidden under panels. */
  #draws() {
    const { store, actions, viewport } = this.#app;
    let hidesEdges = false;
    const stop = effect(() => {
      this.#draw();
      if (!this.laidOut.value || hidesEdges || !store.get().display.edges) return;
      hidesEdges = true;
      actions.display({ edges: false });
    });
    return () => {
      stop();
      viewport.unmeasured((view) =>
        view.setSurfaceLines(new Float64Array(0), Uint32Array.from([0]), 0),
      );
      if (hidesEdges) actions.display({ edges: true });
    };
  }

  /** Draws the panels, or else the place of a refusal. */
  #draw() {
    const panels = this.laidOut.value?.panels;
    const ring = panels ? undefined : this.#refused.value?.points;
    const { points = ring ?? new Float64Array(0), marked = ring ? 1 : 0 } = panels ?? {};
    const ends = panels?.ends ?? Uint32Array.from(ring ? [0, ring.length / 3] : [0]);
    this.#app.viewport.unmeasured((view) => view.setSurfaceLines(points, ends, marked));
  }
}
