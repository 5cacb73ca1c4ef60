/**
 * The docked panel of variations, which keep the shape exact, and of the kept shapes, and the button
 * that opens it.
 */

import './variations.css';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { Docked } from '../../docked/docked.tsx';
import { CommandButton } from '../../store/command-button.tsx';
import { LOCKED, mayKeepShapes } from '../../store/panels-card.ts';
import { isHard, type State } from '../../store/state.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { Kept } from './kept.tsx';
import { VariationCard } from './variation-card.tsx';
import { Variations } from './variations.ts';

/** Whether the shape can be varied, or has kept ones beside it. Their pictures are of faces. */
export function canVary(state: Readonly<State>) {
  if (state.running || !state.document || !state.model?.faces) return false;
  return state.document.variants.length > 0 || isMet(state);
}

const isMet = ({ document: scene, numbers }: Readonly<State>) =>
  Boolean(scene?.constraints.some(isHard) && numbers?.exact?.met);

/** The button of that command, where there are exact constraints or kept shapes. */
export function VariationsButton() {
  const { document: scene } = useApp().store.state;
  if (!scene?.variants.length && !scene?.constraints.some(isHard)) return null;
  return <CommandButton of="variations">Variations</CommandButton>;
}

/** The panel, while it is docked. */
export function VariationsPanel() {
  return useApp().store.state.docked === 'variations' ? <Panel /> : null;
}

function Panel() {
  const app = useApp();
  const variations = useMemo(() => new Variations(app), [app]);
  /** Another panel may have taken its place. */
  const close = () => {
    if (app.store.get().docked === 'variations') app.actions.look({ docked: null });
  };
  useEffect(() => variations.begin(close), [variations]);
  const keep = useRef<HTMLButtonElement>(null);
  useEffect(() => keep.current?.focus(), []);
  const isMoved = variations.isMoved();
  const mayKeep = mayKeepShapes(app.store.state);
  const head = (
    <>
      <p aria-live="polite">{variations.words.value}</p>
      <Button
        title="Moves all sliders to the middle"
        disabled={!isMoved}
        onClick={() => variations.leave()}
      >
        Back
      </Button>
      <button
        ref={keep}
        type="button"
        class="primary"
        title={mayKeep ? 'Keeps this shape and continues from it' : LOCKED}
        disabled={!mayKeep || !isMoved || !variations.isExact.value}
        onClick={() => variations.keep()}
      >
        Keep
      </button>
    </>
  );
  return (
    <Docked of="variations" title="Variations" head={head}>
      <div class="docked-columns variation-columns">
        <div class="variation-cards">
          {variations.found.value.map(({ displacements }, index) => (
            <VariationCard key={displacements} index={index} of={variations} />
          ))}
        </div>
        <Kept />
      </div>
    </Docked>
  );
}
