/** The weights of the paper's figures, to be taken with one choice. */

import { element } from '../dom.js';

/** @typedef {import("../messages.js").Weights} Weights */

/** So short that the closed list cuts nothing off. @type {{ words: string, title: string, weights: Weights }[]} */
const PRESETS = [
  { words: 'Fig. 5: 5, 10, 2', title: 'panels', weights: { shape: 5, close: 10, smooth: 2 } },
  { words: 'Fig. 7: 5, 1, 0', title: 'mesh quality', weights: { shape: 5, close: 1, smooth: 0 } },
  { words: 'Fig. 6, 8: 1, 0, 0', title: 'handles', weights: { shape: 1, close: 0, smooth: 0 } },
];
const OWN = 'own';

/**
 * @param {import("../actions.js").Actions} actions
 * @returns {{ element: HTMLElement, show: (weights: Weights) => void }}
 */
export function weightPresets(actions) {
  const options = PRESETS.map(({ words, title }, at) =>
    element('option', { value: at, title }, words),
  );
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
