/**
 * Presets with the settings of the paper's figures. A preset whose assumptions the mesh does not
 * meet shows a warning first.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import type { PresetOffer } from '../../pkg/engine/shape_up.js';

const CUSTOM = 'custom';

export function WeightPresets() {
  const { store, actions } = useApp();
  const { document, model } = store.state;
  /** The preset that was chosen and is not applied yet. */
  const [chosen, setChosen] = useState<{ id: string; model: unknown } | null>(null);
  const presets = document?.presets ?? [];
  /** It, as long as the mesh does not suit it. */
  const doubtful =
    chosen?.model === model && presets.find(({ id, warning }) => warning && id === chosen?.id);
  const apply = ({ id }: PresetOffer) => actions.edit({ preset: { id } });

  function choose(id: string) {
    const preset = presets.find((one) => one.id === id);
    setChosen(preset?.warning ? { id, model } : null);
    if (preset && !preset.warning) void apply(preset);
  }

  return (
    <div>
      <label class="presets">
        Preset
        <Choice
          aria-label="Preset"
          value={document?.preset ?? CUSTOM}
          options={[
            [CUSTOM, 'Custom'],
            ...presets.map(({ id, label, assumes }) => [id, label, assumes] as const),
          ]}
          isDisabled={(id) => id === CUSTOM}
          onChoose={choose}
        />
      </label>
      {doubtful && (
        <Warning preset={doubtful} apply={() => apply(doubtful)} close={() => setChosen(null)} />
      )}
    </div>
  );
}

function Warning(props: { preset: PresetOffer; apply: () => unknown; close: () => void }) {
  const { preset, apply, close } = props;
  const first = useRef<HTMLButtonElement>(null);
  useEffect(() => first.current?.focus(), [preset.id]);
  const useAnyway = () => {
    close();
    apply();
  };
  return (
    <div class="warning" role="group" aria-labelledby="preset-warning">
      <p id="preset-warning">
        {preset.assumes} {preset.warning}
      </p>
      <Button class="small bordered" ref={first} onClick={useAnyway}>
        Use anyway
      </Button>
      <Button class="small bordered" onClick={close}>
        Cancel
      </Button>
    </div>
  );
}
