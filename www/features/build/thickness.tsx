/**
 * The offset: a slider for distances at which no edge flips, the choice of what keeps the distance,
 * with the error of each, and the weight of following the surface.
 */

import { useState } from 'preact/hooks';
import { AmountField } from '../../ui/components/fields.tsx';
import { HeldSlider } from '../../ui/components/held-slider.tsx';
import { useEntered } from '../../ui/components/use-entered.ts';
import { rounded } from '../../ui/words.ts';
import type { BuildSetting } from '../../pkg/engine/shape_up.js';
import type { Parts } from './parts.ts';

/** Range of the slider in mean edge lengths, if nothing else limits it. */
const FAR = 2;
/** Fraction of the distance at which an edge would have no length. */
const INSIDE = 0.99;
/** Digits of a distance that the slider sets. */
const DIGITS = 4;
/** Exponent to base ten of the smallest weight of following. */
const LEAST_FOLLOW = -5;

/** @param props.declared all settings of Build */
export function Thickness({ parts, declared }: { parts: Parts; declared: BuildSetting[] }) {
  const { report, words } = parts.card.value ?? {};
  /** Where the slider is held. */
  const [held, setHeld] = useState<number | null>(null);
  const { over, enter } = useEntered<number>();
  const offset = report?.offset;
  if (!offset) return null;
  const settings = parts.settings.value;
  const setting = (id: string) => declared.find((one) => one.id === id);
  const [distance, kind, follow] = ['distance', 'kind', 'follow'].map(setting);
  /** Millimetres of the building per unit of the mesh. */
  const unit = parts.live.unit();
  const scale = 1000 * unit.metres;
  const far = FAR * report.mean_edge_mm;
  const [inwards, outwards] = offset.safe_distance_mm;
  // What was entered may not be built yet.
  const at = held ?? over(settings.distance ?? offset.distance_mm / scale);
  return (
    <div class="thickness">
      <div class="heading">
        <label for="parts-distance">{distance?.label}</label>
        <AmountField
          aria-label={`${distance?.label}, in ${unit.symbol}`}
          title={`Empty: ${distance?.absent}`}
          min={-Infinity}
          unit={unit.symbol}
          value={rounded(at, 6)}
          onAmount={(to) => parts.change({ distance: to })}
          onEmpty={() => parts.change({ distance: null })}
        />
        <span class="unit" aria-hidden="true">
          {unit.symbol}
        </span>
      </div>
      <HeldSlider
        id="parts-distance"
        min={Math.max(-far, INSIDE * (inwards ?? -Infinity)) / scale}
        max={Math.min(far, INSIDE * (outwards ?? Infinity)) / scale}
        step="any"
        aria-valuetext={words?.distance}
        at={at}
        // Parts cannot have 0.
        onMove={(to) => {
          setHeld(to);
          if (to !== 0) parts.tryDistance(to);
        }}
        onRelease={(to) => {
          setHeld(null);
          if (to === 0) parts.tryDistance(null);
          else enter(to, parts.change({ distance: rounded(to, DIGITS) }));
        }}
      />
      <p class="quiet">{words?.safe}</p>
      <span id="parts-keeps">{kind?.label}</span>
      <div class="kinds" role="group" aria-labelledby="parts-keeps">
        {kind?.form.type === 'choice' &&
          kind.form.options.map(({ word, label, summary }) => {
            const isChosen = word === settings.kind;
            const isProposed = settings.kind === null && word === offset.kind;
            return (
              <button
                key={word}
                type="button"
                class={isProposed ? 'bordered proposed' : 'bordered'}
                title={summary}
                aria-pressed={isChosen}
                onClick={() => parts.change({ kind: isChosen ? null : word })}
              >
                <span>{label}</span>
                <span class="quiet">
                  {parts.choices.value.find((choice) => choice.kind === word)?.words}
                </span>
              </button>
            );
          })}
      </div>
      {!offset.exact && (
        <div class="field-row">
          <label for="parts-follow">{follow?.label}</label>
          <HeldSlider
            id="parts-follow"
            min={LEAST_FOLLOW}
            max="0"
            step="0.5"
            title={follow?.summary}
            at={Math.log10(settings.follow)}
            onRelease={(exponent) => parts.change({ follow: rounded(10 ** exponent, 2) })}
          />
        </div>
      )}
    </div>
  );
}
