/** The card of a variation: a thumbnail of the deformed shape, and a slider. */

import { useMemo } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { HeldSlider } from '../../ui/components/held-slider.tsx';
import { Thumbnail } from '../../ui/components/thumbnail.tsx';
import { signedPart } from '../../ui/words.ts';
import { STEPS, type Variations } from './variations.ts';

/** Slider position shown in the thumbnail, as a fraction of half the slider's length. */
const PICTURED = 0.6;

export function VariationCard({ index, of }: { index: number; of: Variations }) {
  const { document, dark } = useApp().store.state;
  const { shape, connectivity, displacements, slide } = of.found.value[index];
  const step = of.steps.value[index];
  const range = of.ranges.value[index];
  const known = range?.every(Number.isFinite) ? range : null;
  const [from, to] = known?.map((end) => `${50 + (50 * end) / slide}%`) ?? [];
  const words = signedPart((slide * step) / STEPS);
  const deformed = useMemo(
    () => shape.map((at, i) => at + PICTURED * slide * displacements[i]),
    [shape, displacements],
  );
  return (
    <div
      class="variation-card"
      data-known={known ? '' : undefined}
      style={known ? { '--from': from, '--to': to } : undefined}
    >
      <Thumbnail
        connectivity={connectivity}
        shape={deformed}
        up={document?.up ?? 'z'}
        displacements={displacements}
        dark={dark}
      />
      <div class="heading-row">
        <span>{index + 1}</span>
        <span class="figure">{step !== 0 && words}</span>
      </div>
      <HeldSlider
        min={-STEPS}
        max={STEPS}
        at={step}
        aria-label={`Variation ${index + 1}`}
        aria-valuetext={`${words} of the size`}
        title={
          known ? `Possible from ${known.map(signedPart).join(' to ')} of the size` : undefined
        }
        onMove={(to) => of.move(index, to)}
        onRelease={() => of.release()}
        // Double click resets, as is usual.
        onDblClick={() => {
          of.move(index, 0);
          of.release();
        }}
      />
    </div>
  );
}
