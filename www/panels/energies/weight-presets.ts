/**
 * Presets with the settings of the paper's figures. A preset whose assumptions the mesh does not
 * meet shows a warning first.
 */

import { button, choice, setOptions } from '../../ui/controls/fields.ts';
import { element, removeKeepingFocus } from '../../ui/dom.ts';
import type { Preset, SceneDocument } from '../../solver/types.ts';
import type { Actions } from '../../store/actions.ts';

const CUSTOM = 'custom';
const SMALL = { class: 'small bordered' };

export function weightPresets(actions: Actions): {
  element: HTMLElement;
  show: (document: SceneDocument) => void;
} {
  let presets: Preset[] = [];
  /** The id of the preset that matches the scene. */
  let current: string | null = null;
  const select = choice({ 'aria-label': 'Preset' }, choose);
  const warning = element('div.warning', {
    role: 'group',
    'aria-labelledby': 'preset-warning',
    hidden: true,
  });
  const apply = ({ id }: Preset) => actions.edit({ preset: { id } });

  function choose(chosen: string) {
    const preset = presets.find(({ id }) => id === chosen);
    if (!preset) return;
    if (!preset.warning) return void apply(preset);
    // The preset is not applied yet.
    showChosen();
    const close = () => removeKeepingFocus(warning, () => (warning.hidden = true));
    const useAnyway = () => {
      close();
      void apply(preset);
    };
    warning.replaceChildren(
      element('p', { id: 'preset-warning' }, `${preset.assumes} ${preset.warning}`),
      button('Use anyway', useAnyway, SMALL),
      button('Cancel', close, SMALL),
    );
    warning.hidden = false;
    warning.querySelector('button')?.focus();
  }

  const showChosen = () => (select.value = current ?? CUSTOM);

  return {
    element: element('div', element('label.presets', 'Preset', select), warning),
    show(document) {
      ({ presets, preset: current } = document);
      setOptions(select, [
        [CUSTOM, 'Custom'],
        ...presets.map(({ id, label, assumes }) => [id, label, assumes]),
      ]);
      select.options[0].disabled = true;
      showChosen();
    },
  };
}
