/**
 * What the card says of the panels: how far a run is, and the verdict after it, with presses that end
 * better.
 */

import { signal } from '@preact/signals';
import { latestOnly } from '../../store/latest-only.ts';
import { RENEW_MS, throttled } from '../../ui/dom.ts';
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

export class Verdicts {
  readonly said = signal(NOTHING);
  readonly better = signal(NONE);
  #app;
  #renewals = latestOnly(() => this.#renew());
  #isFollowed = false;
  /** The shape, the tolerance and the unit for which better presses were looked for. */
  #triedFor = '';

  constructor(app: AppContext) {
    this.#app = app;
  }

  /** Follows the shape, until the returned function is called. */
  follow() {
    const { store, solver } = this.#app;
    this.#isFollowed = true;
    const soon = throttled(RENEW_MS, () => {
      if (this.#isFollowed) void this.#renewals.ask();
    });
    const stops = [
      solver.on('frame', soon),
      store.subscribe(['document', 'running', 'press'], soon),
    ];
    return () => {
      this.#isFollowed = false;
      stops.forEach((stop) => stop());
    };
  }

  #goesOn() {
    const { running, press, model } = this.#app.store.get();
    return running || (press?.model === model && press?.isUnderWay === true);
  }

  async #renew() {
    const { store, actions, solver } = this.#app;
    const { model } = store.get();
    const isShown = () => store.get().model === model && this.#isFollowed;
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
    if (press.shape === undefined) press = actions.pressTurns(press, { shape });
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
