/**
 * The legend of the face colours: a histogram of their values over the colour ramp, the ends of the
 * range, the number of faces within the tolerance, and the displacement of the mesh.
 */

import { useEffect, useRef } from 'preact/hooks';
import {
  hasWorst,
  inLegend,
  isCounted,
  movedInWords,
  shownUnit,
  toleranceOf,
} from '../../store/colours/measures.ts';
import { isDrawn } from '../../store/state.ts';
import { useApp } from '../../store/use-app.ts';
import { CloseButton } from '../../ui/components/buttons.tsx';
import { Bars, Outline } from '../../ui/components/histogram.tsx';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { isEmbedded } from '../../ui/embedded.ts';
import { brief, count, groupDigits, measured, number, rounded } from '../../ui/words.ts';
import { cover } from '../../viewport/camera.ts';
import { rampOf } from '../../viewport/ramp.ts';
import { RangeEnd } from './range-end.tsx';
import { useAfterViewUpdate } from './use-after-view-update.ts';
import type { Spread } from '../../store/colours/spread.ts';
import type { FaceMeasure } from '../../pkg/engine/shape_up.js';
import type { Loaded } from '../../solver/types.ts';

/** On a phone in landscape orientation the legend is a strip below the model. */
const strip = matchMedia('(min-width: 700px) and (max-height: 480px)');

export function Legend() {
  const { store, actions, viewport } = useApp();
  const { state } = store;
  const { spread, model, display } = state;
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const box = place.current;
    if (!box) return undefined;
    const update = () => cover(viewport, box, strip.matches && !isEmbedded ? 'bottom' : null);
    const observer = new ResizeObserver(update);
    observer.observe(box);
    return () => observer.disconnect();
  }, []);

  const about = inLegend(state);
  return (
    <div id="legend" ref={place} hidden={!about || !display.legend || !isDrawn(state)}>
      {about && (
        <div class="title">
          <span title={about.words}>{about.label}</span>
          {spread && <Within about={about} spread={spread} />}
          <CloseButton
            label="Close the legend"
            onClick={() => actions.display({ legend: false })}
          />
        </div>
      )}
      {about && model && spread && <Values about={about} spread={spread} model={model} />}
    </div>
  );
}

interface Of {
  about: FaceMeasure;
  spread: Spread;
}

/** The number of faces within the tolerance, unless the card of the panels has it. */
function Within({ about, spread }: Of) {
  const { state } = useApp().store;
  if (toleranceOf(state, about) === null || isCounted(state, about)) return null;
  const [met, all] = [spread.within, spread.faces].map(groupDigits);
  return (
    <span class={met === all ? 'within met' : 'within'} title="Panels within the tolerance">
      {`${met} of ${all} within`}
    </span>
  );
}

function Values({ about, spread, model }: Of & { model: Loaded }) {
  const { store } = useApp();
  const { state } = store;
  const background = useBackground();
  const { range, document, display } = state;
  const ramp = useRef<HTMLDivElement>(null);
  const allowed = toleranceOf(state, about);
  const rounding = model.roundings[about.id];
  const words = (value: number) =>
    measured(Math.abs(value) < rounding ? 0 : value, about.unit, document?.units ?? '', allowed);
  const { axis, places } = spread;
  const limit = 100 * (places.tolerance ?? 0);
  const worst = words(spread.greatest);
  return (
    <>
      <Histogram
        spread={spread}
        least={about.signed ? words(-spread.greatest) : '0'}
        words={words}
      />
      <div ref={ramp} class="ramp" style={{ background }}>
        <div
          class="tick"
          style={{ left: `${limit}%` }}
          hidden={allowed === null || allowed > axis.high}
        />
        {(['low', 'high'] as const).map((end, i) => (
          <RangeEnd
            key={end}
            end={end}
            ramp={ramp}
            spread={spread}
            words={words(range[i])}
            signed={about.signed}
          />
        ))}
      </div>
      <Ends />
      <p class="quiet summary">
        {hasWorst(about) && `${about.signed ? 'Greatest' : 'Worst'} ${worst}\n`}
        <Moved />
      </p>
      {/* Where all faces are coloured, both sides have the colour of the value. */}
      {allowed !== null && !display.full && (
        <p class="quiet summary sides">
          <i class="front" /> front <i class="back" /> back of a face
        </p>
      )}
    </>
  );
}

/** The ramp of the range, as a CSS background. */
function useBackground() {
  const { viewport } = useApp();
  return useAfterViewUpdate(({ spread, display }) => {
    const { low = 0, high = 1, tolerance = null } = spread?.places ?? {};
    const neutral = display.full ? 0 : 100 * (tolerance ?? 0);
    return rampOf(viewport, [100 * low, 100 * high], neutral);
  });
}

/** The distribution of the values, over that of the original. */
function Histogram(props: { spread: Spread; least: string; words: (value: number) => string }) {
  const { spread, least, words } = props;
  const { original } = spread;
  const was = original && words(original.greatest);
  const compared = was === null ? '' : `; originally up to ${was}`;
  return (
    <div
      class="histogram"
      role="img"
      aria-label={`${count(spread.faces, 'face')} between ${least} and ${words(spread.greatest)}${compared}`}
      title={was === null ? '' : `Outline: the original, up to ${was}`}
    >
      <Bars counts={spread.counts} />
      {/* Each histogram is scaled to its own highest bar, to compare their shapes. */}
      {original && <Outline counts={original.counts} most={Math.max(...original.counts)} />}
    </div>
  );
}

/** The ends of the range, the unit, and the step of bands. */
function Ends() {
  const { store, viewport } = useApp();
  const { state } = store;
  const { range } = state;
  const { symbol, factor } = shownUnit(state);
  const step = useAfterViewUpdate(
    (now) => (!now.spread?.axis.log && viewport.unmeasured((view) => view.bandStep())) || null,
  );
  const steps = step && `steps of ${brief(rounded(step * factor, 3))} `;
  return (
    <div class="ends">
      <span>{number(range[0] * factor)}</span>
      <span class="unit">
        {steps}
        {symbol}
      </span>
      <span>{number(range[1] * factor)}</span>
    </div>
  );
}

function Moved() {
  const { state } = useApp().store;
  const moved = useThrottled(() => movedInWords(state));
  return <>{moved && `Moved ${moved}`}</>;
}
