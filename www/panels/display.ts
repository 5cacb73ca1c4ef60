/** Display settings: the measure that colours the faces, and toggles of drawn items. */

import { checkbox, choice, setOptions } from '../ui/controls/fields.ts';
import { byId, element } from '../ui/dom.ts';
import type { AppContext } from '../app/context.ts';

/** Labels of the toggles, in the order of display. */
const TOGGLES = {
  edges: 'Edges',
  vertices: 'Vertices',
  shapes: 'Fitted shapes',
  outlines: 'Projected shapes',
  arrows: 'Residual arrows',
  ghost: 'Original ghost',
  ground: 'Ground grid',
  bands: 'Colours in bands',
  full: 'Full colour map',
  log: 'Logarithmic scale',
  gizmo: 'Gizmo',
  timings: 'Timings',
};

export function displayPanel(place: HTMLElement, { store, actions }: AppContext) {
  const colourBy = choice({ id: 'colour-by' }, (measure) => actions.colourBy(measure || null));
  const colourRow = element(
    'div.field-row',
    element('label', { for: 'colour-by' }, 'Colour by'),
    colourBy,
  );
  const keys = Object.keys(TOGGLES) as (keyof typeof TOGGLES)[];
  const toggles = keys.map((key) =>
    checkbox(TOGGLES[key], (checked) => actions.display({ [key]: checked })),
  );
  place.replaceChildren(colourRow, element('div.toggles', ...toggles.map(({ label }) => label)));

  store.subscribe(['display'], ({ display }) =>
    toggles.forEach(({ box }, i) => (box.checked = display[keys[i]])),
  );
  store.subscribe(['measure', 'measures'], ({ measure, measures }) => {
    setOptions(colourBy, [['', 'nothing'], ...measures.map(({ id, label }) => [id, label])]);
    colourBy.value = measure ?? '';
  });
  // A flat map has colours and controls of its own, which take precedence.
  store.subscribe(['flatMap'], ({ flatMap }) => (colourRow.hidden = flatMap !== null));
  // Only a surface can be flattened.
  const parametrize = byId('parametrize');
  store.subscribe(['model'], ({ model }) => (parametrize.hidden = !model?.faces));
}
