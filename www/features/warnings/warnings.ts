/**
 * Messages about a shape beyond its numbers: problems of its file if the Model panel is hidden,
 * faces of zero area, and the verdict on a run: within the tolerance, or solved as far as possible,
 * with suggestions. Each is shown once, among the messages or on the card of the panels.
 */

import '../../ui/styles/lists.css';
import { button, closeButton } from '../../ui/controls/fields.ts';
import { byId, element, setText } from '../../ui/dom.ts';
import { count, length } from '../../ui/format.ts';
import { isHard } from '../../store/state.ts';
import { showExactVerdict } from './exact-verdict.ts';
import { meshActions } from '../../store/mesh-actions.ts';
import { cover, narrow, showElements } from '../../viewport/camera.ts';
import type { AppContext } from '../../app/context.ts';
import type { Edit } from '../../solver/types.ts';

const ZERO_SIZE = 'zero-size-faces';
/** Maximum number of suggestions offered. */
const MOST_SUGGESTIONS = 3;

export function watchConditions(app: AppContext) {
  const { store, solver, files, viewport, alerts, actions } = app;
  const place = element('div', { 'aria-live': 'polite', id: 'conditions' });
  const messages = byId('messages');
  messages.append(place);
  // The model is framed beside a verdict; other messages move no camera.
  const covers = () =>
    cover(viewport, messages, !place.hasChildNodes() ? null : narrow.matches ? 'bottom' : 'top');
  new ResizeObserver(covers).observe(place);
  narrow.addEventListener('change', covers);
  const mesh = meshActions(store, solver, actions);
  /** Number of zero-area faces when last counted. */
  let flat = 0;
  /** The current message. */
  let shown: HTMLElement | null = null;

  /** Reports the problems of the opened file. */
  function showProblems() {
    const { problems = [] } = store.get().model ?? {};
    const isListed = document.getElementById('model')?.checkVisibility();
    if (problems.length === 0 || isListed) return void lookForFlatFaces();
    const { message, suggestion } = problems.find((problem) => problem.suggestion) ?? problems[0];
    const mend = suggestion && {
      label: suggestion.label,
      action: () =>
        actions.reportErrors(mesh.remesh({ operation: suggestion.operation }, suggestion.label)),
    };
    const words = `${count(problems.length, 'problem')}, see Model: ${message}`;
    alerts.notice(words, ...(mend ? [mend] : []));
  }

  async function lookForFlatFaces() {
    if (!store.get().model?.faces) return;
    const found = await actions.ask.flawed(ZERO_SIZE).catch(() => null);
    const before = flat;
    flat = found?.faces.length ?? 0;
    if (!found || flat === 0 || flat === before) return;
    const [have, they] = flat === 1 ? ['has', 'it is'] : ['have', 'they are'];
    alerts.notice(`${count(flat, 'face')} ${have} zero size; ${they} kept but not coloured.`, {
      label: 'Select',
      action: () => showElements(app, found),
    });
  }

  /** Whether a hint is shown: a first-time user should read one message at a time. */
  const hasHint = () => document.getElementById('hint-card')?.hidden === false;

  /** Reports the result of a run: all within the tolerance, or the worst element and suggestions. */
  async function showVerdict() {
    const { document: scene, numbers } = store.get();
    if (!scene || !numbers) return;
    if (numbers.exact && scene.constraints.some(isHard)) {
      return showExactVerdict(app, {
        showMessage,
        offer,
        hasCard: () => cardOfPanels() !== null,
        hasHint,
      });
    }
    if (hasHint()) return;
    const verdict = await actions.ask.runVerdict().catch(() => null);
    if (!verdict || store.get().document !== scene || store.get().running) return;
    // The card already shows the verdict on the panels.
    const words = cardOfPanels() ? verdict.brief : verdict.full;
    const { worst } = verdict;
    if (!worst) {
      if (words) showMessage(words);
      return;
    }
    const group = showMessage(
      words,
      offer('Show it', () => showElements(app, worst)),
    );
    const waiting = element('p.quiet', 'Looking for changes that help …');
    group.append(waiting);
    const suggestions = await actions.trials.suggestions().catch(() => null);
    if (!suggestions) return waiting.remove();
    const helping = suggestions
      .slice(0, MOST_SUGGESTIONS)
      .map(({ label, edit, worst }) =>
        offer(
          `${label}: ${length(worst, scene.units, scene.tolerance)}`,
          () => take(edit),
          'The largest distance after this change',
        ),
      );
    if (helping.length === 0) setText(waiting, 'None of the changes that were tried lowers it.');
    else waiting.replaceWith(...helping);
  }

  /** The card that shows the verdict on panels, if it is shown. */
  const cardOfPanels = (): HTMLElement | null =>
    document.querySelector('#make-panels-card[data-shows="verdict"]:not([hidden])');

  function offer(label: string, action: () => unknown, title: string = '') {
    const onclick = () => {
      clear();
      action();
    };
    return button(label, onclick, { class: 'small bordered', title });
  }

  /** @returns to which more can be appended */
  function showMessage(text: string, ...buttons: HTMLElement[]): HTMLElement {
    const group = element(
      'div.suggestions',
      { role: 'group', 'aria-label': 'Verdict' },
      element('p', text),
      ...buttons,
    );
    clear();
    const card = cardOfPanels();
    if (card) {
      card.append(group);
    } else {
      group.classList.add('message', 'notice');
      group.append(closeButton('Dismiss the verdict', clear));
      place.append(group);
    }
    shown = group;
    return group;
  }

  function clear() {
    shown?.remove();
    shown = null;
  }

  /** Applies a suggestion and runs on. */
  async function take(edit: Edit) {
    if ((await actions.edit(edit)) !== undefined) actions.run();
  }

  let wasRunning = false;
  solver.on('activity', ({ running, converged }) => {
    if (running) clear();
    const ended = wasRunning && !running;
    wasRunning = running;
    // A collapse has a message of its own.
    if (!ended || store.get().numbers?.collapse) return;
    void lookForFlatFaces();
    if (converged) void showVerdict();
  });
  solver.on('model', () => {
    clear();
    flat = 0;
    wasRunning = false;
  });
  store.subscribe(['document'], clear);
  alerts.clearWith(clear);
  files.on('opened', showProblems);
}
