/** The card of the section plane: its axis, its position and the side that stays visible. */

import { useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { Choice } from '../../ui/components/fields.tsx';
import type { Section } from '../../store/state.ts';

const AXES = ['x', 'y', 'z'].map((axis, i) => [String(i), axis] as const);

/** Shown while there is a section. */
export function SectionCard() {
  const { store, actions } = useApp();
  const { section } = store.state;
  if (!section) return null;
  const set = (change: Partial<Section>) => actions.look({ section: { ...section, ...change } });
  return (
    <div id="section" class="card" role="group" aria-label="Section">
      <label>
        Section{' '}
        <Choice
          aria-label="Section across"
          value={String(section.axis)}
          options={AXES}
          onChoose={(axis) => set({ axis: Number(axis) })}
        />
      </label>
      <input
        type="range"
        min="0"
        max="1"
        step="0.005"
        aria-label="Position of the section"
        value={section.at}
        onInput={({ currentTarget }) => set({ at: currentTarget.valueAsNumber })}
      />
      <Button aria-pressed={section.turned} onClick={() => set({ turned: !section.turned })}>
        Other side
      </Button>
      <CloseButton label="End the section" onClick={() => actions.look({ section: null })} />
    </div>
  );
}
