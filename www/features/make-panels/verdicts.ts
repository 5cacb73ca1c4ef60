/**
 * What is to say of the panels, whether or not the card is there to show it: how far a run is, and the
 * verdict after it, with presses that end better.
 */

import { signal } from '@preact/signals';
import { latestOnly } from '../../store/latest-only.ts';
import { panelsTopic } from '../../store/panels-card.ts';
import { RENEW_MS, throttled } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import type { PanelVerdict } from '../../pkg/engine/shape_up.js';
import type { AppContext } from '../../app/context.ts';

interface Said {
  words: string;
  numbers: string;
  /** null during a run */
  verdict: PanelVerdict | null;
}

const NOTHING: Said = { words: '', numbers: '', verdict: null };

/** What is said of the panels of the open model. */
export const verdicts = once((app: AppContext) => new Verdicts(app));

class Verdicts {
  readonly said = signal(NOTHING);
  /** Whether presses that end better are looked for; those found are in the verdict of the store. */
  readonly isLooking = signal(false);
  #app;
  #renewals = latestOnly(() => this.#renew());
  /** The shape, the tolerance and the unit for which better presses were looked for. */
  #triedFor = '';

  constructor(app: AppContext) {
    this.#app = app;
    const soon = throttled(RENEW_MS, () => {
      if (this.#isAsked()) void this.#renewals.ask();
    });
    const follow = () => {
      if (this.#isAsked()) return soon();
      this.said.value = NOTHING;
      this.#forget();
    };
    app.solver.on('frame', follow);
    app.store.subscribe(['document', 'running', 'press', 'closedCard'], follow);
  }

  /** Whether there is a verdict on the shape, or one to come. */
  #isAsked() {
    return panelsTopic(this.#app.store.get()) === 'verdict';
  }

  #goesOn() {
    const { running, press } = this.#app.store.get();
    return running || press?.isUnderWay === true;
  }

  async #renew() {
    const { store, actions, solver } = this.#app;
    const { model } = store.get();
    const isShown = () => store.get().model === model && this.#isAsked();
    if (this.#goesOn()) {
      const progress = await actions.ask.panelProgress().catch(() => '');
      if (!progress || !isShown() || !this.#goesOn()) return;
      const words = `${store.get().numbers?.attempt ?? ''} ${progress}`.trim();
      this.said.value = { ...NOTHING, words };
      this.#forget();
      return;
    }
    const verdict = await actions.ask.verdict().catch(() => null);
    // Where a run has begun meanwhile, its progress comes next.
    if (verdict === null || !isShown() || this.#goesOn()) return;
    // No panel is asked for a shape any longer.
    if (!verdict) {
      this.said.value = NOTHING;
      return actions.look({ verdict: null });
    }
    const shape = solver.geometry?.generation;
    const asked = `${shape} ${verdict.tolerance} ${verdict.required} ${store.get().document?.units}`;
    const isTried = this.#triedFor === asked;
    const suggestions = (isTried && store.get().verdict?.report.suggestions) || [];
    actions.look({ verdict: { shape, report: { ...verdict, suggestions } } });
    const { brief, numbers } = verdict;
    this.said.value = { words: `${this.#chosen()}${brief}`, numbers, verdict };
    if (verdict.level === 'good') this.#forget();
    else if (verdict.required && !isTried) void this.#findBetter(shape, asked);
  }

  /** The better choice that led to the shape, to begin a verdict with; empty for another shape. */
  #chosen() {
    const { store, solver, actions } = this.#app;
    const shape = solver.geometry?.generation;
    let { press } = store.get();
    if (!press?.label || shape === undefined) return '';
    // The first verdict after the press is on what it led to.
    if (press.shape === undefined) press = actions.updatePress(press, { shape });
    return press.shape === shape ? `${press.label}: ` : '';
  }

  /** Looks for presses that end better; once for what is asked, a shape and what is required of it. */
  async #findBetter(shape: number | undefined, asked: string) {
    const { actions } = this.#app;
    this.#triedFor = asked;
    this.isLooking.value = true;
    const isWanted = () => this.#triedFor === asked;
    const ended = await actions.trials
      .betterPresses((presses) => isWanted() && actions.suggest(shape, presses))
      .catch(() => null);
    if (!isWanted()) return;
    this.isLooking.value = false;
    // Something has changed meanwhile: the next verdict asks again.
    if (ended === false) this.#triedFor = '';
  }

  #forget() {
    this.#triedFor = '';
    this.isLooking.value = false;
  }
}
