/**
 * The settings of the paper's figures, to be taken with one choice. One that assumes what this mesh has
 * not says so before it is taken.
 */

import { element, leave } from '../../ui/dom.js';

/** @typedef {import("../../solver/messages.js").Preset} Preset */

const CUSTOM = 'custom';

/**
 * @param {import("../../store/actions.js").Actions} actions
 * @returns {{ element: HTMLElement, show: (document: import("../../solver/messages.js").SceneDocument) => void }}
 */
export function weightPresets(actions) {
  /** @type {Preset[]} */
  let presets = [];
  /** The one whose settings the scene has. @type {string | null} */
  let current = null;
  const choice = element('select', { 'aria-label': 'Preset', onchange: choose });
  const warning = element('div.warning', {
    role: 'group',
    'aria-labelledby': 'preset-warning',
    hidden: true,
  });
  const take = (/** @type {Preset} */ { id }) => actions.edit({ type: 'preset', id });

  function choose() {
    const preset = presets.find(({ id }) => id === choice.value);
    if (!preset) return;
    if (!preset.warning) return void take(preset);
    // It is not taken yet.
    showChosen();
    const close = () => leave(warning, () => (warning.hidden = true));
    const answer = (/** @type {string} */ label, /** @type {() => void} */ action) =>
      element('button.small.bordered', { onclick: action }, label);
    const useAnyway = () => {
      close();
      take(preset);
    };
    warning.replaceChildren(
      element('p', { id: 'preset-warning' }, `${preset.assumes} ${preset.warning}`),
      answer('Use anyway', useAnyway),
      answer('Cancel', close),
    );
    warning.hidden = false;
    warning.querySelector('button')?.focus();
  }

  const showChosen = () => (choice.value = current ?? CUSTOM);

  return {
    element: element('div', element('label.presets', 'Preset', choice), warning),
    show(document) {
      const isNew = presets.length === 0;
      ({ presets, preset: current } = document);
      if (isNew)
        choice.replaceChildren(
          element('option', { value: CUSTOM, disabled: true }, 'Custom'),
          ...presets.map(({ id, label, assumes }) =>
            element('option', { value: id, title: assumes }, label),
          ),
        );
      showChosen();
    },
  };
}
