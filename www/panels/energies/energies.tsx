/** The three weights of Eq. 13 in plain words, and the current energies. */

import { useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { AmountField } from '../../ui/components/fields.tsx';
import { HeldSlider } from '../../ui/components/held-slider.tsx';
import { useEntered } from '../../ui/components/use-entered.ts';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { energyOrZero, number, rounded } from '../../ui/words.ts';
import { Settings } from './settings.tsx';
import { WeightPresets } from './weight-presets.tsx';
import type { Energy, Document as SceneDocument } from '../../pkg/engine/shape_up.js';

/** The ends of the slider as powers of ten; position 0 means a weight of 0. */
const LEAST = -3;
const MOST = 4;
const STEPS_PER_DECADE = 20;
const LAST = (MOST - LEAST) * STEPS_PER_DECADE;

interface Term {
  id: 'shape' | 'close' | 'smooth';
  label: string;
  words: (document: SceneDocument) => string;
}

/** The terms; the explanation depends on the settings of the scene. */
const TERMS: Term[] = [
  { id: 'shape', label: 'Shape', words: () => 'satisfy the constraints' },
  {
    id: 'close',
    label: 'Close',
    words: (document) => (isOfBoundaryOnly(document) ? BOUNDARY : CLOSENESS[document.closeness]),
  },
  { id: 'smooth', label: 'Smooth', words: ({ smoothness }) => SMOOTHNESS[smoothness] },
];
const CLOSENESS = {
  surface: 'stay near the original',
  rest: 'stay where each vertex was',
  none: 'not used in this scene',
  target: 'lie on the other surface',
};
/** What Close is for if it keeps the boundary only. */
const BOUNDARY = 'stay near the curve of the boundary';
/** Whether Close is the weight of a boundary and of nothing else. A closed mesh has none. */
const isOfBoundaryOnly = ({ closeness, settings, unusedCloseness }: SceneDocument) =>
  closeness === 'none' &&
  settings.boundary === 'soft' &&
  (!unusedCloseness || unusedCloseness.settings.includes('boundary'));
const SMOOTHNESS = { surface: 'keep it smooth', displacement: 'keep the change smooth' };

export function Energies() {
  return (
    <>
      <WeightPresets />
      {TERMS.map((term) => (
        <TermRow key={term.id} term={term} />
      ))}
      <dl class="totals">
        <dt>
          <Swatch of="handles" />
          Handles
        </dt>
        <dd>
          <Amount of="handles" />
        </dd>
        <dt>
          <Swatch of="total" />
          Total
        </dt>
        <dd>
          <Amount of="total" />
        </dd>
      </dl>
      <MoreSettings />
    </>
  );
}

/** A term, its weight and its energy. */
function TermRow({ term: { id, label, words } }: { term: Term }) {
  const { store, actions } = useApp();
  const { document } = store.state;
  const { over, enter } = useEntered<number>();
  const entered = () => over(document?.weights[id] ?? 0);
  /** The weight where the slider is held. */
  const [held, setHeld] = useState<number | null>(null);
  const weight = held ?? entered();
  function send(value: number) {
    const edit = actions.edit({ setWeights: { [id]: value } });
    enter(value, edit);
    return edit;
  }

  // The weight is set on release, so that one gesture is one edit; none if it has come back.
  function release(place: number) {
    setHeld(null);
    if (place !== placeOf(entered())) void send(weightAt(place));
  }

  return (
    <div class="energy">
      <span class="name">
        <Swatch of={id} />
        {label}
        <span class="value figure" title={`${label} energy, without its weight`}>
          <Amount of={id} />
        </span>
      </span>
      <span class="weight">
        <AmountField name={`${label} weight`} value={weight} onAmount={send} />
      </span>
      <span class="words">{document && words(document)}</span>
      <span class="slider">
        <HeldSlider
          min="0"
          max={LAST}
          step="1"
          aria-label={`${label} weight, slider`}
          aria-valuetext={String(weight)}
          at={placeOf(weight)}
          onMove={(place) => setHeld(weightAt(place))}
          onRelease={release}
        />
      </span>
    </div>
  );
}

/** Returns the weight at the position of a slider: 0 at its left end, else two digits. */
function weightAt(place: number) {
  return place === 0 ? 0 : rounded(10 ** (LEAST + place / STEPS_PER_DECADE), 2);
}

function placeOf(weight: number) {
  if (weight <= 0) return 0;
  const place = Math.round((Math.log10(weight) - LEAST) * STEPS_PER_DECADE);
  return Math.min(Math.max(place, 1), LAST);
}

/** A swatch in the colour of the term in the plot. */
const Swatch = ({ of }: { of: keyof Energy }) => (
  <span class="swatch" style={{ '--chip': `var(--series-${of})` }} />
);

/** The current energy of a term. */
function Amount({ of }: { of: keyof Energy }) {
  const { state } = useApp().store;
  const words = useThrottled(() => {
    const { numbers, model } = state;
    return numbers && number(energyOrZero(numbers.energy[of], model?.size ?? 0));
  });
  return <>{words}</>;
}

/** Settings for experts, made when first opened. */
function MoreSettings() {
  const [wasOpened, setWasOpened] = useState(false);
  return (
    <details
      class="more-settings"
      onToggle={({ currentTarget }) => currentTarget.open && setWasOpened(true)}
    >
      <summary>More settings</summary>
      <div class="settings">{wasOpened && <Settings />}</div>
    </details>
  );
}
