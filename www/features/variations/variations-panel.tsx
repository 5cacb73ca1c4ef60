/**
 * The docked panel of variations, which keep the shape exact, and of the kept shapes, and the button
 * that opens it.
 */

import './variations.css';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { Docked } from '../../docked/docked.tsx';
import { isHard } from '../../store/state.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { Kept } from './kept.tsx';
import { VariationCard } from './variation-card.tsx';
import { Variations } from './variations.ts';

/** Opens and closes the panel. */
export function VariationsButton() {
  const { store, actions } = useApp();
  const { state } = store;
  const { document: scene, running, docked } = state;
  const isMet = useThrottled(() => state.numbers?.exact?.met === true);
  const isKept = Boolean(scene?.variants.length);
  if (!isKept && !scene?.constraints.some(isHard)) return null;
  const isReady = !running && (isMet || isKept);
  return (
    <Button
      disabled={!isReady}
      title={
        isReady
          ? 'Other shapes that are as exact as this one'
          : 'Available once the exact constraints are met'
      }
      onClick={() => actions.dock(docked === 'variations' ? null : 'variations')}
    >
      Variations
    </Button>
  );
}

/** The panel, while it is docked. */
export function VariationsPanel() {
  return useApp().store.state.docked === 'variations' ? <Panel /> : null;
}

function Panel() {
  const app = useApp();
  const variations = useMemo(() => new Variations(app), [app]);
  useEffect(() => variations.begin(() => app.actions.dock(null)), [variations]);
  const keep = useRef<HTMLButtonElement>(null);
  useEffect(() => keep.current?.focus(), []);
  const isMoved = variations.isMoved();
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
        title="Makes this the design"
        disabled={!isMoved || !variations.isExact.value}
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
