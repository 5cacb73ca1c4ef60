/** The fields for the selected handles: target, kind and weight. */

import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { handlesNow, type HandleDrag } from '../../store/handles.ts';
import { useApp } from '../../store/use-app.ts';
import { AmountField } from '../../ui/components/fields.tsx';
import { firstIn } from '../../ui/components/number-steps.ts';
import { useThrottled } from '../../ui/components/use-throttled.ts';
import { count, coordinate, decimalsFor } from '../../ui/words.ts';
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
  const shown = AXES.map((_, axis) =>
    common(chosen.map(({ target }) => coordinate(target[axis], decimals))),
  );
  const isTall = shown.some((text) => text !== null && text.length > MOST_BESIDE);
  const unit = document?.units ?? '';
  return (
    <div class="handle-details" role="group" aria-label="Selected handles">
      <p class="quiet">
        {chosen.length === 1
          ? `Handle at vertex ${chosen[0].vertex}`
          : count(chosen.length, 'handle')}
        {document?.units && `, in ${document.units}`}
      </p>
      {/* Input meant for another selection is discarded. */}
      <div key={selection} class={isTall ? 'target tall' : 'target'}>
        {AXES.map((name, axis) => (
          <label key={name}>
            {name}
            <AmountField
              name={`Target ${name}`}
              title="1.5, 1/3 or 20cm; +0.5 moves by that much"
              value={common(chosen.map(({ target }) => target[axis]))}
              shown={shown[axis] ?? ''}
              placeholder={shown[axis] ?? MIXED}
              {...{ unit, min: -Infinity, step: stepOf(unit, decimals) }}
              onAmount={(to) => move(chosen, axis, () => to)}
              onAddToEach={(by) => move(chosen, axis, (from) => from + by)}
            />
          </label>
        ))}
      </div>
      <Hold key={chosen.map(({ vertex }) => vertex).join(' ')} chosen={chosen} />
    </div>
  );
}

/** By what an arrow key changes a coordinate that is shown with so many decimals. */
function stepOf(unit: string, decimals: number) {
  const finest = 10 ** -decimals;
  return Math.min(Math.max(firstIn(unit), finest), 100 * finest);
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
  const latest = useRef<{ drag: HandleDrag; of: string; timer?: ReturnType<typeof setTimeout> }>(
    null,
  );
  useLayoutEffect(() => {
    if (latest.current?.drag.isOver !== false) setAhead(new Map());
  }, [document, refused]);

  /** Moves handles along one axis; what follows at once, as while an arrow key is held, is one step of undo. */
  function move(before: HandleRow[], axis: number, to: (from: number) => number) {
    const after = before.map((handle) => {
      const target = [...handle.target] as HandleRow['target'];
      target[axis] = to(target[axis]);
      return { ...handle, target };
    });
    setAhead(new Map(after.map(({ vertex, target }) => [vertex, target])));
    const of = [axis, ...before.map(({ vertex }) => vertex)].join(' ');
    if (latest.current?.of !== of || latest.current.drag.isOver) {
      latest.current = { drag: actions.drags.begin(before), of };
      // What is saved waits for it: meanwhile the mesh is half way.
      void actions.begin(latest.current.drag.ended);
    }
    const { drag, timer } = latest.current;
    drag.moveTo(Float64Array.from(after.flatMap(({ target }) => target)));
    clearTimeout(timer);
    latest.current.timer = setTimeout(() => drag.end(), FOLLOW_MS);
    actions.setStatus(
      after.length === 1 ? 'Handle moved' : `${count(after.length, 'handle')} moved`,
    );
  }

  return { ahead, move };
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
