/**
 * The card of new panels: they are laid out along the lines of curvature, drawn over the mesh, and
 * taken in its place.
 */

import './new-panels.css';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import { AmountField, Checkbox, Choice } from '../../ui/components/fields.tsx';
import { Pane } from '../../ui/components/pane.tsx';
import { groupDigits } from '../../ui/words.ts';
import { fly, narrow } from '../../viewport/camera.ts';
import { useCover, useNarrow } from '../../viewport/use-cover.ts';
import { Layouts, selectedFaces } from './layouts.ts';
import { makePanels } from './press.ts';
import type { BoundaryForecast, LayoutNote } from '../../pkg/engine/shape_up.js';

/** The choices at the boundary, with the labels of their options and of their forecasts. */
const BOUNDARIES: [BoundaryForecast['boundary'], string, string][] = [
  ['follow', 'Panels follow it', 'Followed'],
  ['cut', 'Panels are cut at it', 'Cut'],
];
/** Followed, unless cut panels move less by more than the forecast may be wrong. */
const AUTOMATIC = 'Automatic';

export function NewPanels() {
  return useApp().store.state.corner === 'new-panels' ? <Card /> : null;
}

function Card() {
  const app = useApp();
  const { store, actions } = app;
  const close = () => actions.leaveCorner('new-panels');
  const layouts = useMemo(() => new Layouts(app, close), [app]);
  useEffect(() => layouts.begin(), [layouts]);
  // The model is framed in the area above the card.
  const place = useCover<HTMLElement>(useNarrow() ? 'bottom' : null);
  useEffect(() => {
    // A field would bring up the keyboard of a phone, over the card.
    const first = narrow.matches ? 'button' : 'input';
    place.current?.querySelector<HTMLElement>(first)?.focus();
  }, []);
  /** The kind of all panels then; empty for none. */
  const [then, setThen] = useState('');
  const { kinds } = store.state;
  const shapes = kinds.filter((kind) => kind.panels !== null).reverse();
  const doing = layouts.doing.value;

  async function use() {
    const kind = store.get().kinds.find(({ id }) => id === then);
    if ((await layouts.use()) && kind) await makePanels(app, kind);
  }

  return (
    <Pane id="new-panels" title="New panels" class="card" row="title" {...{ place, close }}>
      <Sizes layouts={layouts} />
      <Slider layouts={layouts} of="follow" low="Fewer irregular points" high="Moves less" />
      <Slider layouts={layouts} of="even" low="Small panels where it curves" high="Even sizes" />
      <Boundary layouts={layouts} />
      <Kept layouts={layouts} />
      <div class="said" aria-live="polite">
        <Said {...layouts.said.value} />
      </div>
      {doing !== null && (
        <div class="working">
          <progress aria-label="Laying out panels" />
          <span>{doing}</span>
          <Button onClick={() => layouts.cancel()}>Cancel</Button>
        </div>
      )}
      <div class="last">
        <label>
          <span>Then</span>
          <Choice
            value={then}
            options={[
              ['', 'Nothing more'],
              ...shapes.map(({ id, panels }) => [id, `Make panels ${panels}`] as const),
            ]}
            onChoose={setThen}
          />
        </label>
        <Button class="primary" disabled={!layouts.laidOut.value} onClick={use}>
          Use these panels
        </Button>
      </div>
    </Pane>
  );
}

type Of = { layouts: Layouts };

/** The number of panels, or the length of their sides: the other one follows. */
function Sizes({ layouts }: Of) {
  const units = useApp().store.state.document?.units ?? '';
  const { count, size } = layouts.fields.value;
  const suitable = () => layouts.change({ count: null, size: null });
  return (
    <div class="sizes">
      <label>
        <span>Panels</span>
        <AmountField
          name="Panels"
          isWhole
          isPositive
          isReplaced
          value={count ?? null}
          onAmount={(to) => layouts.change({ count: to, size: null })}
          onEmpty={suitable}
        />
      </label>
      <label>
        <span>Side</span>
        <AmountField
          name="Side"
          unit={units}
          isPositive
          isReplaced
          value={size ?? null}
          onAmount={(to) => layouts.change({ size: to, count: null })}
          onEmpty={suitable}
        />
        <span class="unit">{units}</span>
      </label>
    </div>
  );
}

function Slider({
  layouts,
  of,
  low,
  high,
}: Of & { of: 'follow' | 'even'; low: string; high: string }) {
  return (
    <div class="slider">
      <input
        type="range"
        min="0"
        max="1"
        step="any"
        aria-label={`${low} to ${high.toLowerCase()}`}
        value={layouts.settings.value[of]}
        onInput={({ currentTarget }) => layouts.change({ [of]: currentTarget.valueAsNumber })}
      />
      <div class="ends">
        <span>{low}</span>
        <span>{high}</span>
      </div>
    </div>
  );
}

/** What happens at the boundary of an open surface, with the forecast of each choice. */
function Boundary({ layouts }: Of) {
  const isOpen = useRef(false);
  const panels = layouts.laidOut.value?.panels;
  // It stays while others are laid out.
  if (panels) isOpen.current = panels.boundary !== null;
  if (!isOpen.current) return null;
  const known = layouts.forecast.value;
  return (
    <div class="boundary">
      <label>
        <span>Boundary</span>
        <Choice
          value={layouts.settings.value.boundary ?? ''}
          options={[
            ['', AUTOMATIC],
            ...BOUNDARIES.map(([value, label]) => [value, label] as const),
          ]}
          onChoose={(value) =>
            layouts.change({ boundary: BOUNDARIES.find(([one]) => one === value)?.[0] ?? null })
          }
        />
      </label>
      <dl class="quiet" hidden={known?.length === 0}>
        {panels &&
          BOUNDARIES.map(([boundary, , label]) => (
            <div key={boundary} aria-current={boundary === panels.boundary}>
              <dt>{label}</dt>
              <dd>{known?.find((one) => one.boundary === boundary)?.words ?? '…'}</dd>
            </div>
          ))}
      </dl>
    </div>
  );
}

/** Whether the selected faces stay as they are, if some but not all are selected. */
function Kept({ layouts }: Of) {
  const { length } = selectedFaces(useApp().store.state);
  if (length === 0) return null;
  const words =
    length === 1
      ? 'The selected face stays as it is'
      : `The ${groupDigits(length)} selected faces stay as they are`;
  return (
    <Checkbox
      label={words}
      checked={layouts.settings.value.keeps}
      onCheck={(keeps) => layouts.change({ keeps })}
    />
  );
}

/** A sentence and its notes. A note that names places is a button. */
function Said({ words, notes }: { words: string; notes: LayoutNote[] }) {
  return (
    <>
      <p>{words}</p>
      {notes.map((note) => (
        <Note key={note.words} {...note} />
      ))}
    </>
  );
}

/** A note, which brings its place into view; pressed again, the next one. */
function Note({ words, places }: LayoutNote) {
  const { viewport } = useApp();
  const next = useRef(0);
  function show() {
    const around = Uint32Array.from(places[next.current++ % places.length]);
    fly(viewport, (view) => view.fitVertices(around));
  }
  if (!places.length) return <p>{words}</p>;
  return (
    <p>
      <button
        type="button"
        class="place"
        title={places.length > 1 ? 'Shows one place after another' : 'Shows the place'}
        onClick={show}
      >
        {words}
      </button>
    </p>
  );
}
