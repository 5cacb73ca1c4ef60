/** The selected handles in numbers: where they should be, and how they hold. */

import { RENEW_MS, element, setText, throttled } from '../dom.js';
import { count } from '../format.js';
import { handlesNow } from '../state.js';

/** @typedef {import("../messages.js").Handle} Handle */

/** The mesh follows a target that was typed as it does a drag of this long, in milliseconds. */
const FOLLOW_MS = 300;
const AXES = ['x', 'y', 'z'];

/**
 * @param {import("../state.js").Store} store
 * @param {import("../actions.js").Actions} actions
 * @param {import("../solver-client.js").SolverClient} solver
 */
export function handleDetails(store, actions, solver) {
  /** @type {Handle[]} */
  let chosen = [];
  const vertices = () => chosen.map(({ vertex }) => vertex);

  /** Moves the one handle that is selected. */
  function move() {
    const target = targets.map((field) => field.valueAsNumber);
    if (chosen.length !== 1 || !target.every(Number.isFinite)) return show();
    const { vertex } = chosen[0];
    const tell = (/** @type {"start" | "move" | "end"} */ phase, /** @type {number[]} */ to) =>
      solver.tell({
        type: 'drag',
        vertices: Uint32Array.of(vertex),
        targets: Float64Array.from(to),
        phase,
      });
    tell('start', chosen[0].target);
    tell('move', target);
    setTimeout(() => tell('end', target), FOLLOW_MS);
  }

  const title = element('p', { class: 'quiet' });
  const targets = AXES.map((axis) =>
    element('input', {
      type: 'number',
      step: 'any',
      'aria-label': `Target ${axis}`,
      onchange: move,
    }),
  );
  const place = element(
    'div',
    { class: 'target' },
    ...targets.map((field, i) => element('label', {}, AXES[i], field)),
  );
  const kind = (/** @type {string} */ label, /** @type {boolean} */ fixed) =>
    element(
      'button',
      { type: 'button', onclick: () => actions.addHandles(vertices(), fixed) },
      label,
    );
  const [soft, fixed] = [kind('Soft', false), kind('Fixed', true)];
  const weight = element('input', {
    type: 'number',
    min: '0',
    step: 'any',
    'aria-label': 'Weight of the handle',
    onchange: () => {
      if (weight.valueAsNumber > 0)
        actions.edit({ type: 'weighHandles', vertices: vertices(), weight: weight.valueAsNumber });
      else show();
    },
  });
  const weightLabel = element('label', {}, 'weight', weight);
  const all = element(
    'div',
    { class: 'handle-details', role: 'group', 'aria-label': 'Selected handles' },
    title,
    place,
    element(
      'div',
      { class: 'hold' },
      element('span', { class: 'segmented' }, soft, fixed),
      weightLabel,
    ),
  );

  function show() {
    const { selection } = store.get();
    chosen = handlesNow(store.get()).filter(({ vertex }) => selection.vertices.has(vertex));
    all.hidden = chosen.length === 0;
    if (all.hidden) return;
    const [first] = chosen;
    const one = chosen.length === 1;
    setText(title, one ? `Handle at vertex ${first.vertex}` : count(chosen.length, 'handle'));
    place.hidden = !one;
    targets.forEach((field, i) => {
      // While it is typed into, it stays as it is.
      if (document.activeElement !== field)
        field.value = String(Number(first.target[i].toPrecision(9)));
    });
    soft.setAttribute('aria-pressed', String(chosen.every((handle) => !handle.fixed)));
    fixed.setAttribute('aria-pressed', String(chosen.every((handle) => handle.fixed)));
    weightLabel.hidden = chosen.some((handle) => handle.fixed);
    if (document.activeElement !== weight) weight.value = String(first.weight);
  }
  store.subscribe(['document', 'selection'], show);
  store.subscribe(['moved'], throttled(RENEW_MS, show));
  return all;
}
