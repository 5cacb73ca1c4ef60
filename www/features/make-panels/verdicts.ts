/**
 * What is to say of the panels, whether or not the card is there to show it: how far a run is, and the
 * verdict after it, with presses that end better.
 */

import { signal } from '@preact/signals';
import { latestOnly } from '../../store/latest-only.ts';
import { panelsTopic } from '../../store/panels-card.ts';
import { RENEW_MS, throttled } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import type { BetterPress, PanelVerdict } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

interface Said {
  words: string;
  numbers: string;
  /** null during a run */
  verdict: PanelVerdict | null;
}

interface Better {
  presses: BetterPress[];
  isLooking: boolean;
}
const NOTHING: Said = { words: '', numbers: '', verdict: null };
const NONE: Better = { presses: [], isLooking: false };

/** What is said of the panels of the open model. */
export const verdicts = once((app: AppContext) => new Verdicts(app));

class Verdicts {
  readonly said = signal(NOTHING);
  readonly better = signal(NONE);
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
    actions.look({ verdict: { shape: solver.geometry?.generation, report: verdict } });
    const { brief, numbers } = verdict;
    this.said.value = { words: `${this.#chosen()}${brief}`, numbers, verdict };
    if (verdict.level === 'good') this.#forget();
    else void this.#findBetter(verdict);
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

  /** Looks for presses that end better than `verdict`; once for each shape, in the words of each unit. */
  async #findBetter({ tolerance, required }: PanelVerdict) {
    const { store, solver, actions } = this.#app;
    const shape = solver.geometry?.generation;
    const asked = `${shape} ${tolerance} ${required} ${store.get().document?.units}`;
    if (this.#triedFor === asked) return actions.suggest(shape, this.better.value.presses);
    if (!required) return;
    this.#triedFor = asked;
    this.better.value = { presses: [], isLooking: true };
    const isWanted = () => this.#triedFor === asked;
    const ended = await actions.trials
      .betterPresses((presses) => {
        if (isWanted()) this.better.value = { presses, isLooking: true };
        actions.suggest(shape, presses);
      })
      .catch(() => null);
    if (!isWanted()) return;
    this.better.value = { ...this.better.value, isLooking: false };
    // Something has changed meanwhile: the next verdict asks again.
    if (ended === false) this.#triedFor = '';
  }

  #forget() {
    this.#triedFor = '';
    this.better.value = NONE;
  }
}
