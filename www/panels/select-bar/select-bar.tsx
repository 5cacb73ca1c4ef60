/**
 * The selection bar over the view: shape of the drag, selecting through the surface, and the menu
 * of other operations. Shown while the Select tool is active, or something is selected.
 */

import './select-bar.css';
import { createRef } from 'preact';
import { CommandButton } from '../../store/command-button.tsx';
import { describe } from '../../store/selection.ts';
import { useApp } from '../../store/use-app.ts';
import { CloseButton, Icon } from '../../ui/components/buttons.tsx';
import { singleKeys } from '../../ui/keys.ts';

const SHAPES = { box: 'Box', lasso: 'Lasso', paint: 'Paint' };

/** The button that opens the menu, which opens at it. */
export const opener = createRef<HTMLButtonElement>();

export function SelectBar() {
  const { store, actions } = useApp();
  const { tool, shape, touching, adds, brush, selection, model } = store.state;
  const selects = tool === 'select';
  const words = describe(selection);
  return (
    <div
      id="select-bar"
      class="card"
      role="toolbar"
      aria-label="Selection"
      hidden={!model || (!selects && !words)}
    >
      <div class="segmented" role="group" aria-label="Shape of the selection">
        {Object.entries(SHAPES).map(([id, label]) => (
          <CommandButton key={id} of={`shape-${id}`} class="">
            <Icon name={id} />
            <span>{label}</span>
          </CommandButton>
        ))}
      </div>
      <CommandButton of="through" class="toggle through" hidden={!selects}>
        <Icon name="through" />
        <span>Select through</span>
      </CommandButton>
      <button
        type="button"
        class="toggle touching"
        title="Also select what a box or a lasso only touches, whichever way it is drawn"
        aria-pressed={touching}
        hidden={!selects || shape === 'paint'}
        onClick={() => actions.look({ touching: !touching })}
      >
        <Icon name="touching" />
        <span>Touching</span>
      </button>
      {/* Fingers have no Shift. */}
      <button
        type="button"
        class="toggle adds"
        title="Add to the selection instead of replacing it"
        aria-pressed={adds}
        hidden={!words}
        onClick={() => actions.look({ adds: !adds })}
      >
        <Icon name="add" />
        <span>Add to selection</span>
      </button>
      <input
        type="range"
        min="4"
        max="120"
        step="2"
        aria-label="Brush radius"
        title={`Brush radius${singleKeys.on ? ' ([ and ])' : ''}`}
        aria-valuetext={`${Math.round(brush)} pixels`}
        value={brush}
        hidden={!selects || shape !== 'paint'}
        onInput={({ currentTarget }) => actions.look({ brush: currentTarget.valueAsNumber })}
      />
      <button
        ref={opener}
        type="button"
        class="bordered"
        popovertarget="select-menu"
        aria-haspopup="dialog"
        aria-label={words ? `${words}: select by…` : 'Select by…'}
      >
        <span class="said">{words || 'Select by…'}</span>
        <Icon name="chevron" />
      </button>
      <CloseButton
        label="Clear"
        class="square"
        title="Clear the selection (Esc)"
        hidden={!words}
        onClick={actions.selectNothing}
      />
    </div>
  );
}
