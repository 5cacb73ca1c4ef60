/** The three weights of Eq. 13 in plain words, and the current energies. */

import { amountField } from '../../ui/controls/fields.ts';
import { RENEW_MS, element, setText, throttled } from '../../ui/dom.ts';
import { number } from '../../ui/format.ts';
import { energyOrZero } from '../../ui/rounding.ts';
import { settingsPanel } from './settings.ts';
import { weightPresets } from './weight-presets.ts';
import type { Energy, SceneDocument } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';
import type { Store } from '../../store/state.ts';
import type { Actions } from '../../store/actions.ts';

/** The ends of the slider as powers of ten; position 0 means a weight of 0. */
const LEAST = -3;
const MOST = 4;
const STEPS_PER_DECADE = 20;

/** The terms; the explanation depends on the settings of the scene. */
const TERMS: {
  id: 'shape' | 'close' | 'smooth';
  label: string;
  words: (document: SceneDocument) => string;
}[] = [
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

export function energiesPanel(place: HTMLElement, { store, actions }: AppContext) {
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

  store.subscribe(['document', 'refused'], ({ document }) => {
    if (!document) return;
    presets.show(document);
    rows.forEach((row) => row.show(document));
  });
  store.subscribe(
    ['numbers'],
    throttled(RENEW_MS, () => {
      const { numbers, model } = store.get();
      if (!numbers) return;
      const words = (id: keyof Energy) =>
        number(energyOrZero(numbers.energy[id], model?.size ?? 0));
      rows.forEach((row) => row.setEnergy(words(row.id)));
      setText(handles, words('handles'));
      setText(total, words('total'));
    }),
  );
}

/** Settings for experts, made when first opened. */
function moreSettings(store: Store, actions: Actions) {
  const inside = element('div.settings');
  const details = element(
    'details.more-settings',
    {
      ontoggle: () => {
        if (details.open && !inside.hasChildNodes()) settingsPanel(inside, store, actions);
      },
    },
    element('summary', 'More settings'),
    inside,
  );
  return details;
}

function termRow({ id, label, words }: (typeof TERMS)[number], actions: Actions) {
  const send = (weight: number) => actions.edit({ setWeights: { [id]: weight } });
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
    show(scene: SceneDocument) {
      const value = scene.weights[id];
      setText(explanation, words(scene));
      // While it is held, the slider and the field show where it is.
      if (slider.matches(':active')) return;
      weight.show(value);
      slider.value = String(placeOf(value));
      slider.setAttribute('aria-valuetext', String(value));
    },
    setEnergy(text: string) {
      setText(energy, text);
    },
  };
}

/** Returns the weight at a slider position: 0 at its left end, else two digits. */
function weightAt(place: number) {
  return place === 0 ? 0 : Number((10 ** (LEAST + place / STEPS_PER_DECADE)).toPrecision(2));
}

function placeOf(weight: number) {
  if (weight <= 0) return 0;
  const place = Math.round((Math.log10(weight) - LEAST) * STEPS_PER_DECADE);
  return Math.min(Math.max(place, 1), (MOST - LEAST) * STEPS_PER_DECADE);
}

/** A swatch in the colour of the term in the plot. */
function swatch(id: string) {
  return element('span.swatch', { style: `--chip: var(--series-${id})` });
}
