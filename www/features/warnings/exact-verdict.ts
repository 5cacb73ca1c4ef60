/**
 * The verdict on a run with hard constraints: the result, the cost of exactness if only a tolerance
 * was required, and the constraints that cannot be met together.
 */

import './exact-verdict.css';
import { element } from '../../ui/dom.ts';
import { isHard } from '../../store/state.ts';
import { showElements } from '../../viewport/camera.ts';
import type { AppContext as App } from '../../app/context.ts';
import type { ExactReport, ExactWords, TrialWords } from '../../solver/types.ts';

/** Minimum relative decrease of the energy for an improvement to be worth an undo step. */
const LEAST_GAIN = 1e-4;

/** The colour of constraints that cannot be met, sRGB bytes. */
const UNMET: [number, number, number] = [214, 40, 57];

/** Where the verdict is shown. */
interface Output {
  showMessage: (text: string, ...buttons: HTMLElement[]) => HTMLElement;
  /** a button */
  offer: (label: string, action: () => unknown, title?: string) => HTMLElement;
  /** whether the card of the panels already shows their verdict */
  hasCard: () => boolean;
  /** whether a hint is shown, so that good news can wait */
  hasHint: () => boolean;
}

export async function showExactVerdict(app: App, output: Output) {
  const { store, actions } = app;
  const { numbers, document: scene } = store.get();
  if (!numbers?.exact || !scene) return;
  const words = await actions.ask.exactWords().catch(() => null);
  if (!words || store.get().document !== scene || store.get().running) return;
  if (!numbers.exact.met) return showUnmet(app, output, numbers.exact, words);
  const hard = scene.constraints.filter(isHard);
  if (hard.every(({ require }) => require === 'exact')) return showMet(app, output, words);
  await showCost(app, output, words);
}

/** The words of a verdict: what the card of the panels does not show already. */
const saidIn = ({ brief, full }: ExactWords, { hasCard }: Output) => (hasCard() ? brief : full);

/** Shows that all is exact. */
function showMet(app: App, output: Output, words: ExactWords) {
  if (output.hasHint()) return;
  output.showMessage(saidIn(words, output), improveButton(app, output));
}

const improveButton = (app: App, output: Output) =>
  output.offer(
    'Improve',
    () => improve(app, output),
    'Looks for an equally exact shape with less energy',
  );

/** Improves the shape until stopped; reports the gain. */
async function improve(app: App, output: Output) {
  const { actions } = app;
  const { showMessage, offer } = output;
  let isStopped = false;
  const stop = offer('Stop', () => (isStopped = true), 'Keeps the improvement so far');
  const group = showMessage(
    'Improving: looking for an equally exact shape with less energy …',
    stop,
  );
  const found = await actions.reportErrors(
    actions.trials.improvement(() => !isStopped && group.isConnected),
  );
  if (!found || !(isStopped || group.isConnected)) return group.remove();
  const { before, after, words } = found.offer;
  const gained = 1 - after.energy / before.energy;
  if (!(gained > LEAST_GAIN)) {
    showMessage(words.offered);
    return;
  }
  if (!(await actions.exact.accept(found, false))) return group.remove();
  showMessage(words.taken).append(table(words, 'Improved'));
}

/** Reports the cost of exactness. */
async function showCost(app: App, output: Output, words: ExactWords) {
  const { store, actions } = app;
  const { showMessage, offer } = output;
  const { document: scene } = store.get();
  if (!scene) return;
  const say = (next: string, ...buttons: HTMLElement[]) =>
    showMessage(`${saidIn(words, output)} ${next}`.trim(), ...buttons);
  const group = say('Checking how far an exact shape would move …');
  const found = await actions.trials.exactOffer(() => group.isConnected).catch(() => null);
  if (!group.isConnected || !found) return group.remove();
  const { offer: cost } = found;
  if (cost.met && cost.moved.max <= scene.tolerance && cost.folded === 0) {
    if (!(await actions.exact.accept(found, true))) return group.remove();
    say(cost.words.taken, improveButton(app, output));
    return;
  }
  if (cost.tooLarge || !cost.met) {
    say(cost.words.offered);
    return;
  }
  const take = async () => {
    if (!(await actions.exact.accept(found, false))) return;
    const { document: taken } = store.get();
    const exactly = await actions.ask.exactWords().catch(() => null);
    if (exactly && store.get().document === taken) showMet(app, output, exactly);
  };
  say(cost.words.offered, offer('Make exact', take, 'Uses the shape in the right column')).append(
    table(cost.words, 'Exact'),
  );
}

/** @param then heading of the other shape */
function table(words: TrialWords, then: string) {
  const row = ([name, now, then]: [string, string, string]) =>
    element(
      'tr',
      element('th', { scope: 'row' }, name),
      element('td.figure', now),
      element('td.figure', then),
    );
  const heads = [then === 'Exact' ? 'Now' : 'Before', then].map((name) =>
    element('th', { scope: 'col' }, name),
  );
  return element(
    'table.cost',
    { 'aria-label': then === 'Exact' ? 'Cost of exactness' : 'Improvement' },
    element('thead', element('tr', element('td'), ...heads)),
    element('tbody', ...words.table.map(row)),
  );
}

/** Selects and colours the constraints that cannot be met together, and offers suggestions. */
function showUnmet(app: App, output: Output, { worst }: ExactReport, words: ExactWords) {
  const { actions } = app;
  const elements = elementsOf(
    app,
    worst.map(({ vertices }) => vertices),
  );
  const show = () => {
    showElements(app, elements);
    actions.tint({ ...elements, colour: UNMET });
  };
  const suggestions = words.suggestions.map(({ label, index, within }) =>
    output.offer(label, () => actions.exact.require(index, within === null ? 'soft' : { within })),
  );
  output.showMessage(saidIn(words, output), output.offer('Show them', show), ...suggestions);
  show();
}

/**
 * The faces of these constraints, or their vertices if there are none.
 * @param constraints the vertices of each
 */
function elementsOf({ solver }: App, constraints: number[][]) {
  const vertices = Uint32Array.from(new Set(constraints.flat()));
  const faces = [];
  const { faceOffsets, faceIndices } = solver.geometry?.connectivity ?? {};
  if (faceOffsets && faceIndices) {
    const key = (list: Iterable<number>) => [...list].sort((a, b) => a - b).join();
    const wanted = new Set(constraints.map(key));
    for (let face = 0; face + 1 < faceOffsets.length; face++) {
      const corners = faceIndices.subarray(faceOffsets[face], faceOffsets[face + 1]);
      if (wanted.has(key(corners))) faces.push(face);
    }
  }
  const none = new Uint32Array(0);
  return { faces: Uint32Array.from(faces), vertices: faces.length > 0 ? none : vertices };
}
