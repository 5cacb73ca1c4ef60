/**
 * The verdict on a run with hard constraints: the result, the cost of exactness if only a tolerance
 * was required, and the constraints that cannot be met together.
 */

import './exact-verdict.css';
import { element } from '../../ui/dom.ts';
import { count, groupDigits, length, limit, number, part } from '../../ui/format.ts';
import { exactActions } from '../../store/actions/exact-actions.ts';
import { isHard } from '../../store/state.ts';
import { showElements } from '../../viewport/reveal-elements.ts';
import type { AppContext as App } from '../../app/context.ts';
import type { ConstraintRow, ExactOffer, ExactReport } from '../../solver/types.ts';

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
  const { store } = app;
  const { numbers, document: scene } = store.get();
  if (!numbers?.exact || !scene) return;
  if (!numbers.exact.met) return showUnmet(app, output, numbers.exact);
  const hard = scene.constraints.filter(isHard);
  if (hard.every(({ require }) => require === 'exact')) return showMet(app, output, numbers.exact);
  await showCost(app, output);
}

/** Shows that all is exact. */
function showMet(app: App, output: Output, { max_distance, on_guard, shortest_edge }: ExactReport) {
  const { store } = app;
  const { showMessage, hasCard, hasHint } = output;
  const { document: scene, numbers } = store.get();
  if (!scene || !numbers || hasHint()) return;
  const units = scene.units;
  const guarded =
    on_guard > 0
      ? ` ${count(on_guard, 'edge is', 'edges are')} as short as allowed, ${number(shortest_edge ?? 0)} of the original length.`
      : '';
  const { max, mean } = numbers.moved;
  const moved = hasCard()
    ? ''
    : ` Moved at most ${length(max, units)}, ${length(mean, units)} on average.`;
  const text = `Exact: farthest ${length(max_distance, units)}.${moved}${guarded}`;
  showMessage(text, improveButton(app, output));
}

const improveButton = (app: App, output: Output) =>
  output.offer(
    'Improve',
    () => improve(app, output),
    'Looks for an equally exact shape with less energy',
  );

/** Improves the shape until stopped; reports the gain. */
async function improve(app: App, output: Output) {
  const { store, solver, actions } = app;
  const { showMessage, offer } = output;
  const exact = exactActions(solver, actions);
  const units = store.get().document?.units ?? '';
  let isStopped = false;
  const stop = offer('Stop', () => (isStopped = true), 'Keeps the improvement so far');
  const group = showMessage(
    'Improving: looking for an equally exact shape with less energy …',
    stop,
  );
  const found = await actions.reportErrors(actions.trials.improvement(() => !isStopped));
  if (!found) return group.remove();
  const { before, after, moved, maxDistance } = found.offer;
  const gained = 1 - after.energy / before.energy;
  if (!(gained > LEAST_GAIN)) {
    showMessage(
      `There is no better exact shape nearby: the energy stays ${number(before.energy)}.`,
    );
    return;
  }
  const distance = store.get().numbers?.exact?.max_distance ?? maxDistance;
  if (!(await exact.accept(found, false))) return group.remove();
  const words = `Improved: ${part(gained)} less energy, moved by up to ${length(moved.max, units)}.`;
  showMessage(words).append(table(found.offer, distance, units, 'Improved'));
}

/** Reports the cost of exactness. */
async function showCost(app: App, output: Output) {
  const { store, solver, actions } = app;
  const { showMessage, offer, hasCard } = output;
  const { document: scene, model, tolerance, numbers } = store.get();
  if (!scene || !model || !numbers?.exact) return;
  const exact = exactActions(solver, actions);
  const { units } = scene;
  const met = hasCard()
    ? ''
    : `All constraints are met within ${limit(numbers.exact.tolerance, units)}. `;
  const group = showMessage(`${met}Computing the cost of exactness …`);
  const found = await actions.trials.exactOffer(() => group.isConnected).catch(() => null);
  if (!group.isConnected || !found) return group.remove();
  const { offer: cost } = found;
  const allowed = tolerance ?? model.tolerance;
  if (cost.met && cost.moved.max <= allowed && cost.folded === 0) {
    if (await exact.accept(found, true)) {
      const words = `${met}Also made exact: farthest ${length(cost.maxDistance, units)}.`;
      showMessage(words, improveButton(app, output));
    }
    return;
  }
  if (cost.tooLarge) {
    showMessage(
      `${met}The mesh, or one constraint, is too large to be exact; a tolerance can be met.`,
    );
    return;
  }
  if (!cost.met) {
    const constraints = count(cost.misses, 'constraint');
    showMessage(`${met}${constraints} cannot be exact at the same time as the others.`);
    return;
  }
  const folds = cost.folded > 0 ? `, and ${count(cost.folded, 'face')} would fold` : '';
  const take = async () => {
    if (!(await exact.accept(found, false))) return;
    const report = store.get().numbers?.exact;
    if (report) showMet(app, output, report);
  };
  showMessage(
    `${met}If made exact, the shape would move by up to ${length(cost.moved.max, units)} more${folds}.`,
    offer('Make exact', take, 'Uses the shape in the right column'),
  ).append(table(cost, numbers.exact.max_distance, units, 'Exact'));
}

/** @param then heading of the other shape */
function table(
  { before, after, maxDistance }: ExactOffer,
  distance: number,
  units: string,
  then: string,
) {
  const rows: [string, string, string][] = [
    ['Farthest', length(distance, units), length(maxDistance, units, distance)],
    ['Moved at most', length(before.moved.max, units), length(after.moved.max, units)],
    ['on average', length(before.moved.mean, units), length(after.moved.mean, units)],
    ['Energy', number(before.energy), number(after.energy)],
  ];
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
    element('tbody', ...rows.map(row)),
  );
}

/** Selects and colours the constraints that cannot be met together, and offers remedies. */
function showUnmet(app: App, { showMessage, offer }: Output, exact: ExactReport) {
  const { unmet, misses, worst, max_distance, tolerance, contradiction, too_large } = exact;
  const { store, solver, actions } = app;
  const { document: scene } = store.get();
  if (!scene) return;
  const { units } = scene;
  const { require } = exactActions(solver, actions);
  const rows = unmet.flatMap((index) => scene.constraints[index] ?? []);
  const hard = scene.constraints.filter(isHard);
  const all = hard.reduce((sum, row) => sum + row.count, 0);
  const elements = elementsOf(
    app,
    worst.map(({ vertices }) => vertices),
  );
  const show = () => {
    showElements(app, elements);
    actions.tint({ ...elements, colour: UNMET });
  };
  const far = length(max_distance, units, tolerance);
  const change = (row: ConstraintRow) => [
    offer(`Make ${row.label} soft`, () => require(row.index, 'soft')),
    offer(`${row.label} within ${limit(wider(max_distance), units)}`, () =>
      require(row.index, { within: wider(max_distance) }),
    ),
  ];
  const where = rows.map(({ label, on }) => `${label} on ${on}`).join(', ');
  const many = `${groupDigits(misses)} of ${groupDigits(all)}`;
  let [cannot, closest] = ['are not met yet', 'The farthest is off by'];
  if (too_large) cannot = 'are not exact: the mesh, or one constraint, is too large for that';
  else if (contradiction) [cannot, closest] = ['cannot be met together', 'The smallest miss is'];
  showMessage(
    `${many} ${cannot}: ${where}. ${closest} ${far}.`,
    offer('Show them', show),
    ...rows.slice(0, 2).flatMap(change),
  );
  show();
}

/** About 10 % more, to two digits. */
const wider = (value: number) => Number((1.1 * value).toPrecision(2));

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
