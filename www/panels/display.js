/** What the view shows: the colours of the faces with their legend, and what is drawn over them. */

import { byId, element, setText } from '../dom.js';
import { length, lengthUnit } from '../format.js';
import { MEASURES } from '../measures.js';

const STOPS = 12;

/**
 * @param {HTMLElement} place
 * @param {import("../state.js").Store} store
 */
export function displayPanel(place, store) {
  const choice = element(
    'select',
    {
      id: 'colour-by',
      onchange: () => {
        const measure = /** @type {import("../messages.js").Measure} */ (choice.value) || null;
        store.set({ measure, measureChosen: true });
      },
    },
    element('option', { value: '' }, 'nothing'),
    ...Object.entries(MEASURES).map(([id, { label }]) => element('option', { value: id }, label)),
  );
  const toggle = (
    /** @type {keyof import("../state.js").State["display"]} */ key,
    /** @type {string} */ label,
  ) => {
    const box = element('input', {
      type: 'checkbox',
      onchange: () => store.set({ display: { ...store.get().display, [key]: box.checked } }),
    });
    store.subscribe(['display'], ({ display }) => (box.checked = display[key]));
    return element('label', {}, box, label);
  };
  const colourRow = element(
    'div',
    { class: 'field-row' },
    element('label', { for: 'colour-by' }, 'Colour by'),
    choice,
  );
  place.replaceChildren(
    colourRow,
    element(
      'div',
      { class: 'toggles' },
      toggle('edges', 'Edges'),
      toggle('vertices', 'Vertices'),
      toggle('shapes', 'Fitted shapes'),
      toggle('outlines', 'Projected shapes'),
      toggle('arrows', 'Residual arrows'),
    ),
  );
  store.subscribe(['measure'], ({ measure }) => (choice.value = measure ?? ''));
  // The colours of a flat map go before, and it has controls of its own for them.
  store.subscribe(['flatMap'], ({ flatMap }) => (colourRow.hidden = flatMap !== null));
  // Only a surface can be flattened.
  const parametrize = byId('parametrize');
  store.subscribe(['model'], ({ model }) => (parametrize.hidden = !model?.faces));
}

/**
 * @param {HTMLElement} place
 * @param {import("../state.js").Store} store
 * @param {import("../viewport.js").Viewport} viewport
 * @param {() => void} refit
 */
export function legend(place, store, viewport, refit) {
  const title = element('span');
  const ramp = element('div', { class: 'ramp' });
  const low = element('span', { class: 'figure' });
  const high = element('span', { class: 'figure' });
  place.replaceChildren(
    element(
      'div',
      { class: 'title' },
      title,
      element(
        'button',
        {
          type: 'button',
          title: 'Take the range of the colours from the shape as it is',
          onclick: refit,
        },
        'Refit colours',
      ),
    ),
    ramp,
    element('div', { class: 'ends' }, low, high),
  );

  function show() {
    const { measure, range, document, renderer, model, flatMap } = store.get();
    place.hidden =
      !measure ||
      flatMap !== null ||
      !model?.faces ||
      !(renderer === 'webgpu' || renderer === 'webgl2');
    if (!measure || place.hidden) return;
    const units = document?.units ?? '';
    setText(title, MEASURES[measure].label);
    title.title = MEASURES[measure].words;
    setText(low, `0 ${lengthUnit(range[1], units).unit}`);
    setText(high, length(range[1], units));
    const stops = viewport.with((view) => view.colourStops(STOPS)) ?? [];
    ramp.style.background = `linear-gradient(to right, ${stops.join(', ')})`;
  }
  store.subscribe(['measure', 'range', 'document', 'renderer', 'model', 'dark', 'flatMap'], show);
}
