/**
 * The docked panel of variations, which keep the shape exact, and of the kept shapes, and the button
 * that opens it.
 */

import './variations.css';
import { useComputed } from '@preact/signals';
import { render } from 'preact';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { docked } from '../../docked/docked.ts';
import { pressNamed } from '../../store/press.ts';
import { isHard, type State } from '../../store/state.ts';
import { AppProvider, useApp } from '../../store/use-app.ts';
import { Button, CloseButton } from '../../ui/components/buttons.tsx';
import { element } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import { Kept } from './kept.tsx';
import { VariationCard } from './variation-card.tsx';
import { Variations } from './variations.ts';
import type { AppContext } from '../../app/context.ts';

/** Whether the shape can be varied, or has kept ones beside it. */
export function canVary(state: Readonly<State>) {
  if (state.running || !state.document) return false;
  return state.document.variants.length > 0 || isMet(state);
}

const isMet = ({ document: scene, numbers }: Readonly<State>) =>
  Boolean(scene?.constraints.some(isHard) && numbers?.exact?.met);

/** Opens and closes the panel. */
export const toggleVariations = (app: AppContext) => thePanel(app).toggle();

/** The button of that command, where there are exact constraints or kept shapes. */
export function VariationsButton() {
  const app = useApp();
  const { state } = app.store;
  const { document: scene } = state;
  const isReady = useComputed(() => canVary(state)).value;
  if (!scene?.variants.length && !scene?.constraints.some(isHard)) return null;
  return (
    <Button
      disabled={!isReady}
      title={
        isReady
          ? 'Other shapes that are as exact as this one'
          : 'Available once the exact constraints are met'
      }
      onClick={() => pressNamed('variations', app)}
    >
      Variations
    </Button>
  );
}

const thePanel = once((app: AppContext) => {
  const panel = element('section.docked', {
    ...{ id: 'variations-panel', 'aria-labelledby': 'heading-variations', hidden: true },
  });
  const place = docked(panel, {
    opened: () =>
      render(
        <AppProvider value={app}>
          <Panel close={() => place.close()} />
        </AppProvider>,
        panel,
      ),
    closed: () => render(null, panel),
  });
  return place;
});

function Panel({ close }: { close: () => void }) {
  const app = useApp();
  const variations = useMemo(() => new Variations(app), [app]);
  useEffect(() => variations.begin(close), [variations]);
  const keep = useRef<HTMLButtonElement>(null);
  useEffect(() => keep.current?.focus(), []);
  const isMoved = variations.isMoved();
  return (
    <>
      <div class="heading-row">
        <h2 id="heading-variations">Variations</h2>
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
        <CloseButton label="Close variations" onClick={close} />
      </div>
      <div class="docked-columns variation-columns">
        <div class="variation-cards">
          {variations.found.value.map(({ displacements }, index) => (
            <VariationCard key={displacements} index={index} of={variations} />
          ))}
        </div>
        <Kept />
      </div>
    </>
  );
}
