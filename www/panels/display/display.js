/** What the view shows: what the faces are coloured by, and what is drawn over them. */

import { byId, element } from '../../ui/dom.js';

/**
 * @param {HTMLElement} place
 * @param {import("../../store/state.js").Store} store
 */
export function displayPanel(place, store) {
  const choice = element('select', {
    id: 'colour-by',
    onchange: () => {
      const measure =
        /** @type {import("../../solver/messages.js").Measure} */ (choice.value) || null;
      store.set({ measure, measureChosen: true });
    },
  });
  const toggle = (
    /** @type {keyof import("../../store/state.js").State["display"]} */ key,
    /** @type {string} */ label,
  ) => {
    const box = element('input', {
      type: 'checkbox',
      onchange: () => store.set({ display: { ...store.get().display, [key]: box.checked } }),
    });
    store.subscribe(['display'], ({ display }) => (box.checked = display[key]));
    return element('label', box, label);
  };
  const colourRow = element(
    'div.field-row',
    element('label', { for: 'colour-by' }, 'Colour by'),
    choice,
  );
  place.replaceChildren(
    colourRow,
    element(
      'div.toggles',
      toggle('edges', 'Edges'),
      toggle('vertices', 'Vertices'),
      toggle('shapes', 'Fitted shapes'),
      toggle('outlines', 'Projected shapes'),
      toggle('arrows', 'Residual arrows'),
      toggle('ghost', 'Original ghost'),
      toggle('ground', 'Ground grid'),
      toggle('bands', 'Colours in bands'),
      toggle('full', 'Full colour map'),
      toggle('log', 'Logarithmic scale'),
      toggle('gizmo', 'Gizmo'),
      toggle('timings', 'Timings'),
    ),
  );
  store.subscribe(['measure', 'measures'], ({ measure, measures }) => {
    if (choice.options.length !== measures.length + 1) {
      const named = measures.map(({ id, label }) => element('option', { value: id }, label));
      choice.replaceChildren(element('option', { value: '' }, 'nothing'), ...named);
    }
    choice.value = measure ?? '';
  });
  // The colours of a flat map go before, and it has controls of its own for them.
  store.subscribe(['flatMap'], ({ flatMap }) => (colourRow.hidden = flatMap !== null));
  // Only a surface can be flattened.
  const parametrize = byId('parametrize');
  const split = byId('split-button');
  store.subscribe(['model'], ({ model }) => (parametrize.hidden = split.hidden = !model?.faces));
}
