/**
 * What is said about a shape beyond its numbers: problems of its file if its step is hidden,
 * faces of zero area, and the verdict on a run. Each is said once.
 */

import { isInLegend } from '../../store/colours/measures.ts';
import { isLocked } from '../../store/panels-card.ts';
import { isHard } from '../../store/state.ts';
import { untilChanged } from '../../store/until-changed.ts';
import { count, length } from '../../ui/words.ts';
import { once } from '../../ui/once.ts';
import { showElements } from '../../viewport/camera.ts';
import { ExactVerdict } from './exact-verdict.ts';
import { RunMessages } from './run-messages.ts';
import type { AppContext } from '../../app/context.ts';
import type { Edit } from '../../pkg/engine/shape_up.js';

const ZERO_SIZE = 'zero-size-faces';
/** Maximum number of suggestions offered. */
const MOST_SUGGESTIONS = 3;

/** What watches the shape, and the message on its last run. */
export const conditions = once((app: AppContext) => new Conditions(app));

class Conditions {
  readonly messages: RunMessages;
  #app;
  #exact;
  /** Number of zero-area faces when last counted. */
  #flat = 0;

  constructor(app: AppContext) {
    this.#app = app;
    this.messages = new RunMessages(app);
    this.#exact = new ExactVerdict(app, this.messages, hasHint);
    const { store, solver, files, alerts } = app;
    const clear = () => this.messages.withdraw();
    let wasRunning = false;
    solver.on('activity', ({ running, converged }) => {
      if (running) clear();
      const ended = wasRunning && !running;
      wasRunning = running;
      // A collapse has a message of its own.
      if (!ended || store.get().numbers?.collapse) return;
      void this.#lookForFlatFaces();
      if (converged) void this.#showVerdict();
    });
    solver.on('model', () => {
      clear();
      this.#flat = 0;
      wasRunning = false;
    });
    // Who closes the card of the panels has read what is on it.
    store.subscribe(['document', 'closedCard'], clear);
    alerts.clearWith(clear);
    files.on('opened', () => this.#showProblems());
  }

  /** Reports the problems of the opened file. */
  #showProblems() {
    const { store, actions, mesh, alerts } = this.#app;
    const { model, openSteps } = store.get();
    const { problems = [] } = model ?? {};
    const isListed = openSteps.includes('open');
    if (problems.length === 0 || isListed) return void this.#lookForFlatFaces();
    const { message, suggestion } = problems.find((problem) => problem.suggestion) ?? problems[0];
    const repair = suggestion &&
      !isLocked(store.get(), 'mesh') && {
        label: suggestion.label,
        action: () =>
          actions.reportErrors(mesh.remesh({ operation: suggestion.operation }, suggestion.label)),
      };
    const words = `${count(problems.length, 'kind of problem', 'kinds of problem')}, see Open or make: ${message}`;
    untilChanged(store, alerts.notice(words, ...(repair ? [repair] : [])));
  }

  async #lookForFlatFaces() {
    const { store, actions, alerts } = this.#app;
    if (!store.get().model?.faces) return;
    const found = await actions.ask.flawed(ZERO_SIZE).catch(() => null);
    const before = this.#flat;
    const flat = (this.#flat = found?.faces.length ?? 0);
    if (!found || flat === 0 || flat === before) return;
    const [have, they] = flat === 1 ? ['has', 'it is'] : ['have', 'they are'];
    const words = `${count(flat, 'face')} ${have} zero size; ${they} kept but not coloured.`;
    const select = { label: 'Select', action: () => showElements(this.#app, found) };
    untilChanged(store, alerts.notice(words, select));
  }

  /** Reports the result of a run: all within the tolerance, or the worst element and suggestions. */
  async #showVerdict() {
    const { store, actions } = this.#app;
    const { document: scene, numbers } = store.get();
    if (!scene || !numbers) return;
    if (numbers.exact && scene.constraints.some(isHard)) return this.#exact.show();
    if (hasHint()) return;
    const verdict = await actions.ask.runVerdict().catch(() => null);
    if (!verdict || store.get().document !== scene || store.get().running) return;
    const { worst, brief: words } = verdict;
    if (!worst) return void this.messages.say({ result: words, words: '' });
    const show = { label: 'Show it', act: () => showElements(this.#app, worst) };
    const row = scene.constraints.find(({ index }) => index === worst.row);
    const elsewhere = isInLegend(store.get(), row?.measure ?? null) ? 'in-legend' : 'in-rows';
    const message = this.messages.say({
      words,
      isOpen: true,
      numbers: { words: verdict.numbers, elsewhere },
      offers: [show],
      waits: 'Looking for suggestions …',
    });
    const suggestions = await actions.trials.suggestions().catch(() => null);
    if (!suggestions) return this.messages.update(message, { waits: '' });
    const helping = suggestions.slice(0, MOST_SUGGESTIONS).map(({ label, edit, worst }) => ({
      label: `${label}: worst ${length(worst, scene.units, scene.tolerance)}`,
      title: 'The largest distance after this change',
      changes: true,
      act: () => this.#take(edit),
    }));
    const waits =
      helping.length > 0 ? '' : 'No suggestion was found that makes the largest distance smaller.';
    this.messages.update(message, { waits, offers: [show, ...helping] });
  }

  /** Applies a suggestion and runs on. */
  async #take(edit: Edit) {
    const { actions } = this.#app;
    if ((await actions.edit(edit)) !== undefined) actions.run();
  }
}

/** Whether a hint is shown: a first-time user should read one message at a time. */
const hasHint = () => document.getElementById('hint-card')?.checkVisibility() ?? false;
