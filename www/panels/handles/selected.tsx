/** The fields for the selected handles: target, kind and weight. */

import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { messageOf } from '../../solver/errors.ts';
import { handlesNow, type HandleDrag } from '../../store/handles.ts';
import { useApp } from '../../store/use-app.ts';
import { AmountField } from '../../ui/components/fields.tsx';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { count, coordinate, decimalsFor, readLength } from '../../ui/words.ts';
import type { HandleRow } from '../../pkg/engine/shape_up.js';

/** The length of the simulated drag by which the mesh follows a typed target, in milliseconds. */
const FOLLOW_MS = 300;
const AXES = ['x', 'y', 'z'];
const MIXED = 'mixed';
/** Longer numbers are placed one below the other. */
const MOST_BESIDE = 8;

export function SelectedHandles() {
  const { store, actions } = useApp();
  const { state } = store;
  const { document, selection, model } = state;
  const drag = useThrottled(() => ({ dragged: state.dragged, moved: state.moved }));
  const { ahead, move } = useTypedTargets();
  const selected = new Set(actions.selectedVertices());
  const chosen = handlesNow({ document, ...drag })
    .filter(({ vertex }) => selected.has(vertex))
    .map((handle) => ({ ...handle, target: ahead.get(handle.vertex) ?? handle.target }));
  if (chosen.length === 0) return null;
  const decimals = decimalsFor(model?.size ?? 0);
  return (
    <div class="handle-details" role="group" aria-label="Selected handles">
      <p class="quiet">
        {chosen.length === 1
          ? `Handle at vertex ${chosen[0].vertex}`
          : count(chosen.length, 'handle')}
        {document?.units && `, in ${document.units}`}
      </p>
      {/* Input meant for another selection is discarded. */}
      <Targets
        key={selection}
        values={AXES.map((_, axis) =>
          common(chosen.map(({ target }) => coordinate(target[axis], decimals))),
        )}
        enter={(axis, text) => move(chosen, axis, text)}
      />
      <Hold key={chosen.map(({ vertex }) => vertex).join(' ')} chosen={chosen} />
    </div>
  );
}

/** Returns the value that all handles have; null if they differ. */
function common<Value>(values: Value[]) {
  return values.every((value) => value === values[0]) ? (values[0] ?? null) : null;
}

/** Targets that were typed: the mesh follows them, and they are shown before it has arrived. */
function useTypedTargets() {
  const { store, actions } = useApp();
  const { document, refused } = store.state;
  /** Targets not yet in the document, by vertex. */
  const [ahead, setAhead] = useState<ReadonlyMap<number, HandleRow['target']>>(new Map());
  const drag = useRef<HandleDrag>(null);
  useLayoutEffect(() => {
    if (drag.current?.isOver !== false) setAhead(new Map());
  }, [document, refused]);

  /**
   * Moves handles along one axis, as one step of undo.
   * @throws if the text is no length
   */
  function move(before: HandleRow[], axis: number, text: string) {
    const entry = readLength(text, store.get().document?.units ?? '');
    const after = before.map((handle) => {
      const target = [...handle.target] as HandleRow['target'];
      target[axis] = entry.by ? target[axis] + entry.length : entry.length;
      return { ...handle, target };
    });
    setAhead(new Map(after.map(({ vertex, target }) => [vertex, target])));
    const moving = actions.drags.begin(before);
    drag.current = moving;
    moving.moveTo(Float64Array.from(after.flatMap(({ target }) => target)));
    setTimeout(() => moving.end(), FOLLOW_MS);
    // What is saved waits for it: meanwhile the mesh is half way.
    void actions.begin(moving.ended);
    actions.setStatus(
      after.length === 1 ? 'Handle moved' : `${count(after.length, 'handle')} moved`,
    );
  }

  return { ahead, move };
}

/** Input of a field that is not entered, and what is wrong with it. */
interface Typed {
  text: string;
  problem?: string;
}

/**
 * The fields for the coordinates.
 * @param props.values null for mixed ones
 * @param props.enter throws if the text is no length
 */
function Targets(props: {
  values: (string | null)[];
  enter: (axis: number, text: string) => void;
}) {
  const { values, enter } = props;
  const [typed, setTyped] = useState<(Typed | null)[]>(AXES.map(() => null));
  const shown = values.map((value, axis) => typed[axis]?.text ?? value ?? '');
  const isTall = Math.max(...shown.map((text) => text.length)) > MOST_BESIDE;
  const problem = typed.find((one) => one?.problem)?.problem;
  const set = (axis: number, to: Typed | null) =>
    setTyped((before) => before.map((one, i) => (i === axis ? to : one)));

  function change(axis: number, text: string) {
    try {
      if (text.trim() !== '') enter(axis, text);
      set(axis, null);
    } catch (error) {
      set(axis, { text, problem: messageOf(error) });
    }
  }

  return (
    <>
      <div class={isTall ? 'target tall' : 'target'}>
        {AXES.map((name, axis) => (
          <label key={name}>
            {name}
            <input
              class="number"
              type="text"
              autocomplete="off"
              spellcheck={false}
              title="1.5, 1/3 or 20cm; +0.5 moves by that much"
              aria-label={`Target ${name}`}
              aria-describedby="target-error"
              aria-invalid={typed[axis]?.problem ? 'true' : undefined}
              placeholder={values[axis] === null ? MIXED : ''}
              value={shown[axis]}
              onInput={({ currentTarget }) =>
                set(axis, { ...typed[axis], text: currentTarget.value })
              }
              onChange={({ currentTarget }) => change(axis, currentTarget.value)}
              onKeyDown={(event) => {
                if (event.key !== 'Escape' || !typed[axis]) return;
                event.stopPropagation();
                set(axis, null);
              }}
              // Invalid input stays, to be corrected.
              onBlur={() => setTyped((now) => now.map((one) => (one?.problem ? one : null)))}
            />
          </label>
        ))}
      </div>
      <p class="error" id="target-error" aria-live="polite">
        {problem}
      </p>
    </>
  );
}

/** Whether the handles are fixed, and the weight of those that are not. */
function Hold({ chosen }: { chosen: HandleRow[] }) {
  const { actions } = useApp();
  const soft = chosen.filter((handle) => !handle.fixed);
  const weight = common(soft.map((handle) => handle.weight));
  const vertices = chosen.map(({ vertex }) => vertex);
  return (
    <div class="hold">
      <span class="segmented">
        <button
          type="button"
          aria-pressed={soft.length === chosen.length}
          onClick={() => actions.soften(vertices)}
        >
          Soft
        </button>
        <button
          type="button"
          aria-pressed={soft.length === 0}
          onClick={() => actions.addHandles(vertices, true)}
        >
          Fixed
        </button>
      </span>
      {soft.length > 0 && (
        <label>
          weight
          <AmountField
            name="Weight of the handle"
            value={weight}
            placeholder={weight === null ? MIXED : ''}
            isPositive
            onAmount={(value) => {
              const vertices = soft.map(({ vertex }) => vertex);
              return actions.edit({ weighHandles: { vertices, weight: value } });
            }}
          />
        </label>
      )}
    </div>
  );
}
