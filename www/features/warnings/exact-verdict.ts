/**
 * The verdict on a run with hard constraints: the result, the cost of exactness if only a tolerance
 * was required, and the constraints that cannot be satisfied together.
 */

import { isLocked } from '../../store/panels-card.ts';
import { FAILED, isHard } from '../../store/state.ts';
import { showElements } from '../../viewport/camera.ts';
import type { AppContext as App } from '../../app/context.ts';
import type { ExactReport, ExactWords } from '../../pkg/engine/shape_up.js';
import type { Offer, RunMessages } from './run-messages.ts';

/** Minimum relative decrease of the energy for an improvement to be worth an undo step. */
const LEAST_GAIN = 1e-4;

export class ExactVerdict {
  #app;
  #messages;
  #hasHint;

  /** @param hasHint whether a hint is shown, so that good news can wait */
  constructor(app: App, messages: RunMessages, hasHint: () => boolean) {
    this.#app = app;
    this.#messages = messages;
    this.#hasHint = hasHint;
  }

  async show() {
    const { store, actions } = this.#app;
    const { numbers, document: scene } = store.get();
    if (!numbers?.exact || !scene) return;
    const words = await actions.ask.exactWords().catch(() => null);
    if (!words || store.get().document !== scene || store.get().running) return;
    if (!numbers.exact.met) return this.#showUnmet(numbers.exact, words);
    const hard = scene.constraints.filter(isHard);
    if (hard.every(({ require }) => require === 'exact')) return this.#showMet(words);
    await this.#showCost(words, scene.tolerance);
  }

  /** Shows that all is exact. */
  #showMet(words: ExactWords) {
    if (this.#hasHint()) return;
    this.#messages.say({ result: words.brief, words: '', offers: [this.#improves()] });
  }

  #improves(): Offer {
    return {
      label: 'Improve',
      title:
        'Keeps what is required satisfied, and looks for a shape that is better in all else: closeness, smoothness, soft constraints',
      act: () => this.#improve(),
    };
  }

  /** Improves the shape until stopped; reports the gain. */
  async #improve() {
    const { actions } = this.#app;
    let isStopped = false;
    const stop: Offer = {
      label: 'Stop',
      title: 'Keeps the improvement so far',
      act: () => (isStopped = true),
    };
    const message = this.#messages.say({
      words: 'Improving: looking for a shape that is better in all else …',
      isOpen: true,
      offers: [stop],
    });
    const isWanted = () => this.#messages.isShown(message);
    const found = await actions.reportErrors(
      actions.trials.improvement(() => !isStopped && isWanted()),
    );
    if (!found || !(isStopped || isWanted())) return this.#messages.withdraw(message);
    const { before, after, words } = found.offer;
    const gained = 1 - after.energy / before.energy;
    if (!(gained > LEAST_GAIN)) {
      this.#messages.say({ words: words.offered });
      return;
    }
    if (!(await actions.exact.accept(found, false))) return this.#messages.withdraw(message);
    this.#messages.say({ words: words.taken });
  }

  /** Reports the cost of exactness. */
  async #showCost(words: ExactWords, tolerance: number) {
    const { store, actions } = this.#app;
    const result = words.brief;
    const message = this.#messages.say({
      result,
      words: 'Checking how far an exact shape would move …',
      isOpen: true,
    });
    const isWanted = () => this.#messages.isShown(message);
    const found = await actions.trials.exactOffer(isWanted).catch(() => undefined);
    if (!isWanted()) return;
    if (!found) {
      this.#messages.withdraw(message);
      // There is nothing to offer: the shape is exact, or a lesson locks what would make it so.
      if (found === null) this.#showMet(words);
      return;
    }
    const { offer: cost } = found;
    if (cost.met && cost.moved.max <= tolerance && cost.folded === 0) {
      if (!(await actions.exact.accept(found, true))) return this.#messages.withdraw(message);
      this.#messages.say({ result, words: cost.words.taken, offers: [this.#improves()] });
      return;
    }
    if (cost.tooLarge || !cost.met) {
      this.#messages.say({ result, words: cost.words.offered });
      return;
    }
    const take = async () => {
      const isTaken = await actions.exact.accept(found, false);
      if (isTaken === false) actions.setStatus('Nothing was changed: another shape is shown now');
      if (!isTaken) return;
      const { document: taken } = store.get();
      const exactly = await actions.ask.exactWords().catch(() => null);
      if (exactly && store.get().document === taken) this.#showMet(exactly);
    };
    this.#messages.say({
      result,
      words: cost.words.offered,
      isOpen: true,
      numbers: { words: cost.words.away, elsewhere: 'where-room' },
      offers: [
        {
          label: 'Make exact',
          title: 'Replaces the shape by the exact one',
          changes: true,
          act: take,
        },
      ],
    });
  }

  /** Selects and colours the constraints that cannot be met together, and offers suggestions. */
  #showUnmet({ worst }: ExactReport, words: ExactWords) {
    const { store, actions } = this.#app;
    const elements = elementsOf(
      this.#app,
      worst.map(({ vertices }) => vertices),
    );
    const show = () => {
      showElements(this.#app, elements);
      actions.tint('unmet', { ...elements, colour: FAILED });
    };
    const isFixed = isLocked(store.get(), 'constraints');
    // The rows as they are now: another one may have this index when the offer is taken.
    const rows = store.get().document?.constraints ?? [];
    const suggestions = (isFixed ? [] : words.suggestions).map(({ label, index, within }) => ({
      label,
      changes: true,
      act: () => actions.exact.require(rows[index], within === null ? 'soft' : { within }),
    }));
    this.#messages.say({
      words: words.brief,
      isOpen: true,
      numbers: { words: words.numbers, elsewhere: 'in-rows' },
      // Their colours end with the message, and so would what helps.
      offers: [{ label: 'Show them', stays: true, act: show }, ...suggestions],
    });
    show();
  }
}

/**
 * The faces of these constraints, and the vertices of those that are on no face.
 * @param constraints the vertices of each
 */
function elementsOf({ solver }: App, constraints: number[][]) {
  const key = (list: Iterable<number>) => [...list].sort((a, b) => a - b).join();
  const wanted = new Set(constraints.map(key));
  const found = new Set<string>();
  const faces = [];
  const { faceOffsets, faceIndices } = solver.geometry?.connectivity ?? {};
  if (faceOffsets && faceIndices) {
    for (let face = 0; face + 1 < faceOffsets.length; face++) {
      const corners = key(faceIndices.subarray(faceOffsets[face], faceOffsets[face + 1]));
      if (!wanted.has(corners)) continue;
      faces.push(face);
      found.add(corners);
    }
  }
  const others = constraints.filter((vertices) => !found.has(key(vertices)));
  return { faces: Uint32Array.from(faces), vertices: Uint32Array.from(new Set(others.flat())) };
}
