/**
 * What is worth saying of a shape beyond its numbers: faces without an area, and a run that ended
 * though its constraints are not met. Said in the place of the messages, once each time.
 */

import '../style/lists.css';
import { element, icon } from '../dom.js';
import { count, length } from '../format.js';
import { declared } from '../measures.js';
import { showElements } from './show.js';

/** An error below this part of an edge is not seen, and mostly not built. */
const PART_OF_EDGE = 1e-3;
const ZERO_SIZE = 'zero-size-faces';

/**
 * The error that is nothing to speak of: the tolerance, where one is given for lengths.
 * @param {Readonly<import("../state.js").State>} state
 * @param {import("../messages.js").Loaded} model
 */
function allowed(state, model) {
  const inLengths = declared(state, state.measure)?.unit === 'length';
  return inLengths && state.tolerance !== null ? state.tolerance : PART_OF_EDGE * model.meanEdge;
}

/** @param {import("../analysis.js").Parts} parts */
export function watchConditions(parts) {
  const { store, solver, files, alerts, actions } = parts;
  const place = element('div', { 'aria-live': 'polite', id: 'conditions' });
  document.getElementById('messages')?.append(place);
  /** Faces without an area when they were last counted. */
  let flat = 0;

  async function lookForFlatFaces() {
    if (!store.get().model?.faces) return;
    const found = await solver.request({ type: 'flawed', flaw: ZERO_SIZE }).catch(() => null);
    const before = flat;
    flat = found?.faces.length ?? 0;
    if (!found || flat === 0 || flat === before) return;
    const [have, they] = flat === 1 ? ['has', 'it is'] : ['have', 'they are'];
    alerts.notice(`${count(flat, 'face')} ${have} zero size; ${they} kept but not coloured.`, {
      label: 'Select',
      action: () => showElements(parts, found),
    });
  }

  async function lookForCompromise() {
    const { document: scene, numbers, model } = store.get();
    if (!scene || !numbers || !model) return;
    const errors = scene.constraints.map(({ index, enabled, weight }) =>
      enabled && weight > 0 ? (numbers.worst[index] ?? 0) : 0,
    );
    const greatest = Math.max(0, ...errors);
    const hints = document.getElementById('hint-card');
    // Whoever is here for the first time reads one thing at a time.
    if (greatest <= allowed(store.get(), model) || hints?.hidden === false) return;
    const row = scene.constraints[errors.indexOf(greatest)];
    const request = { measure: null, row: row.index, count: 1 };
    const [worst] = await solver.request({ type: 'worst', ...request }).catch(() => []);
    if (!worst || store.get().document !== scene) return;
    const { running } = store.get();
    if (!running) tell(row, worst, scene.units);
  }

  /**
   * @param {import("../messages.js").ConstraintRow} row
   * @param {import("../messages.js").WorstElement} worst
   * @param {string} units
   */
  function tell(row, worst, units) {
    const act = (/** @type {() => unknown} */ action) => () => {
      clear();
      action();
    };
    const button = (/** @type {string} */ label, /** @type {() => unknown} */ action) =>
      element('button', { type: 'button', class: 'small bordered', onclick: act(action) }, label);
    place.replaceChildren(
      element(
        'div',
        { class: 'message notice', role: 'group', 'aria-label': 'Compromise' },
        element(
          'p',
          {},
          `Best compromise reached: not everything can be met at once. Worst: ${row.label} on ${worst.element} (${length(worst.value, units)}).`,
        ),
        button('Show it', () => showElements(parts, worst)),
        button('Lower weight', () => lower(row)),
        element(
          'button',
          { type: 'button', class: 'tiny', 'aria-label': 'Dismiss the compromise', onclick: clear },
          icon('close'),
        ),
      ),
    );
  }

  function clear() {
    place.replaceChildren();
  }

  /** Halves the weight of what is farthest from being met, and goes on. @param {import("../messages.js").ConstraintRow} row */
  async function lower(row) {
    const weight = row.weight / 2;
    const done = await actions.edit({ type: 'setConstraint', index: row.index, weight });
    if (done === undefined) return;
    solver.tell({ type: 'run' });
  }

  let wasRunning = false;
  solver.addEventListener('activity', (event) => {
    const { running, converged } = /** @type {CustomEvent} */ (event).detail;
    if (running) clear();
    const ended = wasRunning && !running;
    wasRunning = running;
    if (!ended) return;
    lookForFlatFaces();
    if (converged) lookForCompromise();
  });
  solver.addEventListener('model', () => {
    clear();
    flat = 0;
    wasRunning = false;
  });
  store.subscribe(['document'], clear);
  files.addEventListener('opened', lookForFlatFaces);
  lookForFlatFaces();
}
