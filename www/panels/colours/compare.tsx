/** The shape beside the original: held in its place, or drawn around it. */

import { useEffect, useRef } from 'preact/hooks';
import { isDrawn } from '../../store/state.ts';
import { useApp } from '../../store/use-app.ts';
import { Checkbox } from '../../ui/components/fields.tsx';

export function Compare() {
  const { store, actions, hold } = useApp();
  const { state } = store;
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (button.current) hold.bind(button.current);
  }, [hold]);
  return (
    <div class="field-row">
      <button
        ref={button}
        type="button"
        class="bordered"
        title="Shows the original as long as it is held"
        disabled={!state.document || !isDrawn(state)}
      >
        Hold to see the original
      </button>
      <Checkbox
        label="Ghost of the original"
        checked={state.display.ghost}
        onCheck={(ghost) => actions.display({ ghost })}
      />
    </div>
  );
}
