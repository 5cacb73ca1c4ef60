/** The selected handles in numbers: where they should be, and how they hold. Comes with the first. */

import './handle-details.css';
import { RENEW_MS, element, setText, throttled } from '../../ui/dom.js';
import { count } from '../../ui/format.js';
import { messageOf } from '../../solver/messages.js';
import { coordinate, decimalsFor, readLength } from '../../ui/number-entry.js';
import { handlesNow } from '../../store/state.js';

/** @typedef {import("../../solver/messages.js").Handle} Handle */

/** The mesh follows a target that was typed as it does a drag of this long, in milliseconds. */
const FOLLOW_MS = 300;
const AXES = ['x', 'y', 'z'];
const MIXED = 'mixed';
/** Numbers with more characters stand one below the other. */
const MOST_BESIDE = 8;

/**
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../store/actions.js").Actions} actions
 */
export function handleDetails(store, actions) {
  /** @type {Handle[]} */
  let chosen = [];
  /** Where handles are to be that the document does not know yet. @type {Map<number, Handle["target"]>} */
  const ahead = new Map();
  /** Ends the move that the mesh still follows. @type {(() => void) | null} */
  let pending = null;
  /** @param {(handle: Handle) => boolean} [which] */
  const vertices = (which = () => true) => chosen.filter(which).map(({ vertex }) => vertex);

  /** Moves all selected handles along one axis, as one step of undo. @param {number} axis */
  function move(axis) {
    const field = targets[axis];
    if (field.value.trim() === '') return leave(field);
    /** @type {ReturnType<typeof readLength>} */
    let entry;
    try {
      entry = readLength(field.value, store.get().document?.units ?? '');
    } catch (problem) {
      field.setAttribute('aria-invalid', 'true');
      return setText(error, messageOf(problem));
    }
    const before = chosen;
    pending?.();
    for (const { vertex, target } of before) {
      const to = /** @type {Handle["target"]} */ ([...target]);
      to[axis] = entry.by ? to[axis] + entry.length : entry.length;
      ahead.set(vertex, to);
    }
    typed.delete(field);
    show();
    const after = chosen;
    actions.moveHandles(before, 'start');
    actions.moveHandles(after, 'move');
    const timer = setTimeout(() => pending?.(), FOLLOW_MS);
    pending = () => {
      clearTimeout(timer);
      pending = null;
      actions.moveHandles(after, 'end');
    };
    actions.setStatus(
      after.length === 1 ? 'Handle moved' : `${count(after.length, 'handle')} moved`,
    );
  }

  const title = element('p.quiet');
  const error = element('p.error', { id: 'target-error', 'aria-live': 'polite' });
  /** Fields with something in them that is not taken over yet. @type {Set<HTMLInputElement>} */
  const typed = new Set();
  const targets = AXES.map((axis, at) => {
    const field = element('input.number', {
      type: 'text',
      autocomplete: 'off',
      spellcheck: 'false',
      title: '1.5, 1/3 or 20cm; +0.5 moves by that much',
      'aria-label': `Target ${axis}`,
      'aria-describedby': error.id,
      oninput: () => typed.add(field),
      onchange: () => move(at),
      onkeydown: (/** @type {KeyboardEvent} */ event) => {
        if (event.key !== 'Escape' || !typed.has(field)) return;
        event.stopPropagation();
        leave(field);
      },
      // What is wrong stays, to be set right.
      onblur: () => field.hasAttribute('aria-invalid') || leave(field),
    });
    return field;
  });
  const place = element(
    'div.target',
    ...targets.map((field, i) => element('label', AXES[i], field)),
  );
  const kind = (/** @type {string} */ label, /** @type {boolean} */ fixed) =>
    element(
      'button',
      {
        // Those that are so already keep their weight.
        onclick: () => {
          const others = vertices((handle) => handle.fixed !== fixed);
          if (others.length > 0) actions.addHandles(others, fixed);
        },
      },
      label,
    );
  const [soft, fixed] = [kind('Soft', false), kind('Fixed', true)];
  const weight = element('input', {
    type: 'number',
    min: '0',
    step: 'any',
    'aria-label': 'Weight of the handle',
    oninput: () => typed.add(weight),
    onchange: () => {
      typed.delete(weight);
      const value = weight.valueAsNumber;
      if (!(value > 0)) return show();
      actions.edit({
        type: 'weighHandles',
        vertices: vertices((handle) => !handle.fixed),
        weight: value,
      });
    },
  });
  const weightLabel = element('label', 'weight', weight);
  const all = element(
    'div.handle-details',
    { role: 'group', 'aria-label': 'Selected handles' },
    title,
    place,
    error,
    element('div.hold', element('span.segmented', soft, fixed), weightLabel),
  );

  /** What was typed is not wanted. @param {HTMLInputElement} field */
  function leave(field) {
    typed.delete(field);
    show();
  }

  /**
   * Shows what the handles have in common.
   * @param {HTMLInputElement} field stays as it is while it is typed into
   * @param {string[]} values of each handle
   */
  function showCommon(field, values) {
    if (typed.has(field)) return;
    const isCommon = values.every((value) => value === values[0]);
    field.value = isCommon ? (values[0] ?? '') : '';
    field.placeholder = isCommon ? '' : MIXED;
  }

  function show() {
    const selected = new Set(actions.chosenVertices());
    chosen = handlesNow(store.get())
      .filter(({ vertex }) => selected.has(vertex))
      .map((handle) => ({ ...handle, target: ahead.get(handle.vertex) ?? handle.target }));
    all.hidden = chosen.length === 0;
    if (all.hidden) return typed.clear();
    const one = chosen.length === 1;
    setText(title, one ? `Handle at vertex ${chosen[0].vertex}` : count(chosen.length, 'handle'));
    const decimals = decimalsFor(store.get().size);
    targets.forEach((field, i) => {
      const values = chosen.map(({ target }) => coordinate(target[i], decimals));
      showCommon(field, values);
      if (!typed.has(field)) field.removeAttribute('aria-invalid');
    });
    if (!targets.some((field) => field.hasAttribute('aria-invalid'))) setText(error, '');
    const longest = Math.max(...targets.map(({ value }) => value.length));
    place.classList.toggle('tall', longest > MOST_BESIDE);
    const held = chosen.filter((handle) => !handle.fixed);
    soft.setAttribute('aria-pressed', String(held.length === chosen.length));
    fixed.setAttribute('aria-pressed', String(held.length === 0));
    weightLabel.hidden = held.length === 0;
    showCommon(
      weight,
      held.map((handle) => String(handle.weight)),
    );
  }
  store.subscribe(['document'], () => {
    if (!pending) ahead.clear();
    show();
  });
  // What was typed was for the handles that were selected.
  store.subscribe(['selection'], () => {
    typed.clear();
    show();
  });
  store.subscribe(['moved'], throttled(RENEW_MS, show));
  return all;
}
