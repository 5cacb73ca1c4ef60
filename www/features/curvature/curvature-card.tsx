/**
 * The curvature card: strokes along the principal directions or lines of curvature on the surface,
 * and the consequences for panels. "Colour by" has the measures of curvature.
 */

import './curvature.css';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { useForecastWords } from '../../store/use-forecast-words.ts';
import { AmountField, Choice } from '../../ui/components/fields.tsx';
import { Pane } from '../../ui/components/pane.tsx';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { number } from '../../ui/words.ts';
import { CurvatureLines } from './curvature-lines.ts';
import type { Lines, LinesQuestion } from '../../solver/types.ts';

type Drawn = LinesQuestion['draw'] | '';
const LINES: [Drawn, string][] = [
  ['strokes', 'Principal directions'],
  ['lines', 'Lines of curvature'],
  ['', 'No lines'],
];
const KEYS = ['Larger curvature', 'Smaller curvature'];

export function Curvature() {
  return useApp().store.state.corner === 'curvature' ? <Card /> : null;
}

function Card() {
  const { store, actions } = useApp();
  const { document, model } = store.state;
  const [draw, setDraw] = useState<Drawn>('strokes');
  /** Between lines; null for one that suits the model. */
  const [distance, setDistance] = useState<number | null>(null);
  useEffect(() => setDistance(null), [model]);
  const { answer, refused } = useLines(draw, distance);
  const place = useRef<HTMLElement>(null);
  useEffect(() => place.current?.querySelector('select')?.focus(), []);
  const close = () => actions.leaveCorner('curvature');
  return (
    <Pane id="curvature" title="Curvature" class="card" row="title" {...{ place, close }}>
      <Choice
        aria-label="Lines"
        value={draw}
        options={LINES}
        onChoose={(value) => setDraw(value as Drawn)}
      />
      {draw === 'lines' && (
        <label class="apart">
          <span>Spacing</span>
          <AmountField
            name="Spacing of the lines"
            unit={document?.units}
            value={distance}
            placeholder={answer ? number(answer.distance) : ''}
            isPositive
            onAmount={setDistance}
            onEmpty={() => setDistance(null)}
          />
          <span class="unit">{document?.units ?? ''}</span>
        </label>
      )}
      <div class="key">{draw && <Keys />}</div>
      <p class="quiet" aria-live="polite">
        {refused || wordsOf(draw, answer)}
      </p>
      <Consequences />
    </Pane>
  );
}

/** What is missing, in words. */
function wordsOf(draw: Drawn, answer: Lines | null) {
  const found = (answer?.offsets.length ?? 1) - 1;
  if (found || draw === '' || !answer) return '';
  const what = draw === 'strokes' ? 'directions' : 'lines of curvature';
  return `No ${what}: the surface is flat or equally curved in all directions.`;
}

/** What the colours of the lines mean; they depend on the colours of the faces. */
function Keys() {
  const { store, viewport } = useApp();
  const { state } = store;
  useThrottled(() => [state.dark, state.measure, state.spread]);
  const colours = viewport.unmeasured((view) => view.lineColours());
  return (
    <>
      {KEYS.map((words, i) => (
        <span key={words}>
          <i style={{ background: colours?.[i] ?? '' }} />
          {words}
        </span>
      ))}
    </>
  );
}

/** What the curvature means for panels. */
function Consequences() {
  const words = useForecastWords(true)?.words;
  return <p hidden={!words}>{words}</p>;
}

/** Draws the lines of the current shape. */
function useLines(draw: Drawn, distance: number | null) {
  const app = useApp();
  const lines = useMemo(() => new CurvatureLines(app), [app]);
  useEffect(() => lines.begin(), [lines]);
  useEffect(() => {
    void lines.draw(draw === '' ? null : { draw, distance: draw === 'lines' ? distance : null });
  }, [draw, distance]);
  return lines.result.value;
}
