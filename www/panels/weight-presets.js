/** The weights of the paper's figures, to be taken with one choice. */

import { element } from '../dom.js';

/** @typedef {import("../messages.js").Weights} Weights */

/** @type {{ words: string, weights: Weights }[]} */
const PRESETS = [
  { words: 'Fig. 5, panels: 5, 10, 2', weights: { shape: 5, close: 10, smooth: 2 } },
  { words: 'Fig. 7, mesh quality: 5, 1, 0', weights: { shape: 5, close: 1, smooth: 0 } },
  { words: 'Fig. 6 and 8, handles: 1, 0, 0', weights: { shape: 1, close: 0, smooth: 0 } },
];
const OWN = 'own';

/**
 * @param {import("../actions.js").Actions} actions
 * @returns {{ element: HTMLElement, show: (weights: Weights) => void }}
 */
export function weightPresets(actions) {
  const options = PRESETS.map(({ words }, at) => element('option', { value: at }, words));
  const own = element('option', { value: OWN, disabled: true }, 'own weights');
  const choice = element(
    'select',
    {
      'aria-label': 'Weights of the paper',
      onchange: () => {
        const { weights } = PRESETS[Number(choice.value)];
        actions.edit({ type: 'setWeights', ...weights });
      },
    },
    own,
    ...options,
  );
  return {
    element: element('label', { class: 'presets' }, 'As in the paper', choice),
    show(weights) {
      const at = PRESETS.findIndex(({ weights: one }) =>
        ['shape', 'close', 'smooth'].every((id) => one[id] === weights[id]),
      );
      choice.value = at < 0 ? OWN : String(at);
    },
  };
}
