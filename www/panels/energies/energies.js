/** The three weights of Eq. 13 in plain words, and the current energies. */

import { amountField } from '../../ui/controls/fields.js';
import { RENEW_MS, element, setText, throttled } from '../../ui/dom.js';
import { number } from '../../ui/format.js';
import { energyOrZero } from '../../ui/rounding.js';
import { weightPresets } from './weight-presets.js';

/** @typedef {import("../../solver/messages.js").SceneDocument} SceneDocument */

/** The ends of the slider as powers of ten; position 0 means a weight of 0. */
const LEAST = -3;
const MOST = 4;
const STEPS_PER_DECADE = 20;

/**
 * The terms; the explanation depends on the settings of the scene.
 * @type {{ id: "shape" | "close" | "smooth", label: string, words: (document: SceneDocument) => string }[]}
 */
const TERMS = [
  { id: 'shape', label: 'Shape', words: () => 'meet the constraints' },
  { id: 'close', label: 'Close', words: ({ closeness }) => CLOSENESS[closeness] },
  { id: 'smooth', label: 'Smooth', words: ({ smoothness }) => SMOOTHNESS[smoothness.of] },
];
const CLOSENESS = {
  surface: 'stay near the original',
  rest: 'stay where each vertex was',
  none: 'not used in this scene',
  target: 'lie on the other surface',
};
const SMOOTHNESS = { surface: 'keep it smooth', displacement: 'keep the change smooth' };

/**
 * @param {HTMLElement} place
 * @param {import("../../app/context.js").AppContext} app
 */
export function energiesPanel(place, { store, actions }) {
  const rows = TERMS.map((term) => termRow(term, actions));
  const presets = weightPresets(actions);
  const handles = element('dd');
  const total = element('dd');
  place.replaceChildren(
    presets.element,
    ...rows.map((row) => row.element),
    element(
      'dl.totals',
      element('dt', swatch('handles'), 'Handles'),
      handles,
      element('dt', swatch('total'), 'Total'),
      total,
    ),
    moreSettings(store, actions),
  );

  store.subscribe(['document'], ({ document }) => {
    if (!document) return;
    presets.show(document);
    rows.forEach((row) => row.show(document));
  });
  store.subscribe(
    ['numbers'],
    throttled(RENEW_MS, () => {
      const { numbers, size } = store.get();
      if (!numbers) return;
      const words = (/** @type {keyof import("../../solver/messages.js").Energy} */ id) =>
        number(energyOrZero(numbers.energy[id], size));
      rows.forEach((row) => row.setEnergy(words(row.id)));
      setText(handles, words('handles'));
      setText(total, words('total'));
    }),
  );
}

/**
 * Settings for experts, loaded when first opened.
 * @param {import("../../store/state.js").Store} store
 * @param {import("../../store/actions.js").Actions} actions
 */
function moreSettings(store, actions) {
  const inside = element('div.settings');
  const fill = async () => {
    const { settingsPanel } = await import('./settings.js');
    if (!inside.hasChildNodes()) settingsPanel(inside, store, actions);
  };
  const details = element(
    'details.more-settings',
    {
      ontoggle: () => {
        if (details.open && !inside.hasChildNodes()) actions.reportErrors(fill());
      },
    },
    element('summary', 'More settings'),
    inside,
  );
  return details;
}

/**
 * @param {typeof TERMS[number]} term
 * @param {import("../../store/actions.js").Actions} actions
 */
function termRow({ id, label, words }, actions) {
  const send = (/** @type {number} */ weight) => actions.edit({ type: 'setWeights', [id]: weight });
  const weight = amountField(`${label} weight`, send);
  const { field } = weight;
  const slider = element('input', {
    type: 'range',
    min: '0',
    max: String((MOST - LEAST) * STEPS_PER_DECADE),
    step: '1',
    'aria-label': `${label} weight, slider`,
    oninput: () => {
      field.value = String(weightAt(slider.valueAsNumber));
      slider.setAttribute('aria-valuetext', field.value);
    },
    // The weight is set on release, so that one gesture is one edit.
    onchange: () => send(weightAt(slider.valueAsNumber)),
  });
  const explanation = element('span.words');
  const energy = element('span.value.figure', { title: `${label} energy, without its weight` });
  return {
    id,
    element: element(
      'div.energy',
      element('span.name', swatch(id), label, energy),
      element('span.weight', field),
      explanation,
      element('span.slider', slider),
    ),
    /** @param {SceneDocument} scene */
    show(scene) {
      const value = scene.weights[id];
      setText(explanation, words(scene));
      weight.show(value);
      slider.value = String(placeOf(value));
      slider.setAttribute('aria-valuetext', String(value));
    },
    /** @param {string} text */
    setEnergy(text) {
      setText(energy, text);
    },
  };
}

/**
 * Returns the weight at a slider position: 0 at its left end, else two digits.
 * @param {number} place
 */
function weightAt(place) {
  return place === 0 ? 0 : Number((10 ** (LEAST + place / STEPS_PER_DECADE)).toPrecision(2));
}

/** @param {number} weight */
function placeOf(weight) {
  if (weight <= 0) return 0;
  const place = Math.round((Math.log10(weight) - LEAST) * STEPS_PER_DECADE);
  return Math.min(Math.max(place, 1), (MOST - LEAST) * STEPS_PER_DECADE);
}

/** A swatch in the colour of the term in the plot. @param {string} id */
function swatch(id) {
  return element('span.swatch', { style: `--chip: var(--series-${id})` });
}
