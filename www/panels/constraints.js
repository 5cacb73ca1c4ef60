/**
 * The list of constraints. Rows are kept while the list has the same rows, so that a field that is
 * being typed into is not taken away by a frame.
 */

import { element, icon, setText, throttled } from '../dom.js';
import { groupDigits, length } from '../format.js';
import { lengthOrNothing } from '../rounding.js';

/** @typedef {import("../messages.js").ConstraintRow} ConstraintRow */

/** The numbers of a run change on the page this often, in milliseconds. */
const NUMBERS_EVERY_MS = 100;
const NONE = new Uint32Array(0);

/**
 * @param {HTMLElement} place
 * @param {import("../state.js").Store} store
 * @param {import("../solver-client.js").SolverClient} solver
 * @param {import("../actions.js").Actions} actions
 */
export function constraintsPanel(place, store, solver, actions) {
  /** @type {HTMLElement[]} */
  let worstCells = [];
  /** The rows that are on the page. */
  let shown = '';

  /** Tints what a constraint acts on. @param {ConstraintRow} row */
  async function tint(row) {
    const members = await actions.told(solver.request({ type: 'members', constraint: row.index }));
    const hovered = place.querySelector('.constraint:is(:hover, :focus-within)');
    if (members && hovered?.getAttribute('data-index') === String(row.index)) {
      // Dots on the corners of tinted faces would say nothing more.
      const vertices = members.faces.length > 0 ? NONE : members.vertices;
      store.set({ tint: { faces: members.faces, vertices, colour: row.colour } });
    }
  }

  function untint() {
    store.set({ tint: null });
  }

  /** @param {ConstraintRow} row */
  function rowOf(row) {
    const set = (/** @type {{ weight?: number, enabled?: boolean }} */ change) =>
      actions.edit({ type: 'setConstraint', index: row.index, ...change });
    const name = `${row.label} on ${row.on}`;
    const toggle = element('input', {
      type: 'checkbox',
      role: 'switch',
      'aria-label': `${name}: on`,
      title: row.enabled ? 'On' : 'Off',
      onchange: () => set({ enabled: toggle.checked }),
    });
    toggle.checked = row.enabled;
    const weight = element('input', {
      type: 'number',
      min: '0',
      step: 'any',
      value: String(row.weight),
      'aria-label': `${name}: weight`,
      onchange: () => {
        if (weight.validity.valid && weight.value !== '') set({ weight: weight.valueAsNumber });
        else weight.value = String(row.weight);
      },
    });
    const remove = element(
      'button',
      {
        type: 'button',
        class: 'tiny',
        'aria-label': `${name}: remove`,
        title: 'Remove',
        onclick: () => {
          untint();
          actions.edit({ type: 'removeConstraint', index: row.index });
        },
      },
      icon('close'),
    );
    const worst = element('span', { class: 'worst figure' });
    worstCells.push(worst);
    const skipped = row.skipped > 0 ? `, ${groupDigits(row.skipped)} skipped` : '';
    return element(
      'li',
      {
        class: `constraint${row.enabled ? '' : ' off'}`,
        'data-index': row.index,
        onpointerenter: (/** @type {PointerEvent} */ event) => {
          if (event.pointerType !== 'touch') tint(row);
        },
        onpointerleave: untint,
        onfocusin: () => tint(row),
        onfocusout: untint,
      },
      element('span', { class: 'chip', style: `--chip: rgb(${row.colour.join(' ')})` }),
      element('span', { class: 'name' }, row.label),
      element('span', { class: 'buttons' }, element('label', { class: 'switch' }, toggle), remove),
      element('span', { class: 'on' }, `${row.on} · ${groupDigits(row.count)}${skipped}`),
      element('span', { class: 'measures' }, element('label', {}, 'weight', weight), worst),
    );
  }

  const showNumbers = throttled(NUMBERS_EVERY_MS, () => {
    const { numbers, document, size } = store.get();
    document?.constraints.forEach((row, i) => {
      const value = numbers?.worst[i];
      if (!worstCells[i]) return;
      const known = row.enabled && value !== undefined;
      const text = known ? `worst ${length(lengthOrNothing(value, size), document.units)}` : '';
      setText(worstCells[i], text);
    });
  });

  store.subscribe(['document'], ({ document }) => {
    if (!document) return;
    const rows = JSON.stringify([document.units, document.constraints]);
    if (rows === shown) return;
    shown = rows;
    worstCells = [];
    untint();
    const focused = focusedField(place);
    place.replaceChildren(
      document.constraints.length > 0
        ? element('ul', { 'aria-label': 'Constraints' }, ...document.constraints.map(rowOf))
        : element(
            'p',
            { class: 'quiet' },
            'Nothing is asked of this mesh yet. Add a constraint, then press Run.',
          ),
    );
    if (focused) {
      /** @type {HTMLElement | null} */
      const again = place.querySelector(`[aria-label="${CSS.escape(focused)}"]`);
      again?.focus();
    }
    showNumbers();
  });
  store.subscribe(['numbers'], showNumbers);
}

/** The accessible name of the field that has the focus, to give it back. @param {HTMLElement} place */
function focusedField(place) {
  const { activeElement } = document;
  return place.contains(activeElement) ? activeElement?.getAttribute('aria-label') : null;
}
