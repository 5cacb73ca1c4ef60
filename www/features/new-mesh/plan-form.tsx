/** The form of a plan: an outline drawn or typed, its division into panels, and its height. */

import './plan.css';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { Button } from '../../ui/components/buttons.tsx';
import { AmountField, Checkbox, Choice } from '../../ui/components/fields.tsx';
import { firstIn } from '../../ui/components/number-steps.ts';
import { SizeField } from '../../ui/components/size-field.tsx';
import { limit, rounded } from '../../ui/words.ts';
import { bulgeOf } from '../../pkg/engine/shape_up.js';
import { DrawnPlan, nameOf, PLAN, roundedPlace, type Plan, type Sketch } from './plan.ts';
import { PlanDrawing } from './plan-drawing.tsx';
import { useKept, type Kept } from './use-kept.ts';
import type { Accepted } from '../../ui/components/number-input.tsx';
import type { Asked } from './trial.ts';

const HINT = 'Drag points; pull the middle of a side to make it an arc. Hold Alt to move freely.';
const DRAW_HINT =
  'Click or tap to place points, and the first one again to close the loop. Undo removes the last point.';
const LAYOUTS = [
  ['follow', 'Along the outline'],
  ['cut', 'A grid, cut to fit'],
] as const;
const SUPPORTS = [
  ['corners', 'Its corners'],
  ['outline', 'The whole outline'],
] as const;
/** Limits of a length in the plan. */
const LENGTH = { of: 'length', least: 1e-6, most: 1e6 } as const;
/** The sizes of the whole plan. */
const SIZES = [
  { id: 'size', label: 'Panel', ...LENGTH },
  { id: 'height', label: 'Height', ...LENGTH, least: 0 },
  { id: 'turn', label: 'Turned by', of: 'degrees', least: -180, most: 180 },
] as const;

export function PlanForm({
  unit,
  kept,
  ask,
}: {
  unit: string;
  kept: Kept;
  ask: (asked: Asked) => void;
}) {
  const [drawn] = useKept(kept, PLAN.id, () => new DrawnPlan(unit));
  useLayoutEffect(() => drawn.convert(unit), [unit]);
  // What is wrong in a field goes with the field.
  useLayoutEffect(() => () => void (drawn.problems.value = {}), []);
  const plan = drawn.plan.value;
  const problems = drawn.problems.value;
  useLayoutEffect(
    () => ask({ make: () => drawn.mesh(), kept: () => drawn.keep() }),
    [plan, problems],
  );
  const sketch = drawn.sketch.value;

  function onKeyDown(event: KeyboardEvent) {
    if (event.key === 'Escape' && sketch) {
      event.preventDefault();
      drawn.endSketch();
    }
    // A number field has an undo of its own.
    const isText =
      event.target instanceof HTMLInputElement && event.target.matches('[role=spinbutton]');
    if (event.key === 'z' && (event.ctrlKey || event.metaKey) && !isText) {
      event.preventDefault();
      drawn.undo();
    }
  }

  return (
    <div class="plan" onKeyDown={onKeyDown}>
      <div class="dialog-buttons">
        <Button onClick={() => drawn.beginSketch('outline')}>Draw the outline</Button>
        <Button onClick={() => drawn.beginSketch('hole')}>Draw a hole</Button>
        <Button onClick={() => drawn.startOver()}>Start over</Button>
        <Button disabled={drawn.steps.value.length === 0 && !sketch} onClick={() => drawn.undo()}>
          Undo
        </Button>
      </div>
      <PlanDrawing drawn={drawn} />
      <p class="quiet hint">{sketch ? hintFor(sketch, drawn.unit.value) : HINT}</p>
      <SelectedPoint drawn={drawn} />
      <label>
        <span>Panels</span>
        <Choice
          value={plan.layout}
          options={LAYOUTS}
          onChoose={(layout) => {
            drawn.step((plan) => (plan.layout = layout as Plan['layout']));
            // Its field goes.
            drawn.problems.value = { ...problems, [SIZES[2].label]: '' };
          }}
        />
      </label>
      <label>
        <span>Stands on</span>
        <Choice
          value={plan.stands}
          options={SUPPORTS}
          onChoose={(stands) => drawn.step((plan) => (plan.stands = stands as Plan['stands']))}
        />
      </label>
      <Sizes drawn={drawn} />
    </div>
  );
}

/** The length of the last side, once there is one. */
function hintFor({ places, pointer }: Sketch, unit: string) {
  const all = [...places, ...(pointer ? [pointer] : [])];
  const lengths = all.slice(1).map((at, k) => Math.hypot(at[0] - all[k][0], at[1] - all[k][1]));
  const last = lengths.findLast((length) => length > 0);
  return last ? limit(rounded(last, 4), unit) : DRAW_HINT;
}

/** Place and side of the selected point. */
function SelectedPoint({ drawn }: { drawn: DrawnPlan }) {
  const spot = drawn.selected.value;
  const { point, side } = drawn.now();
  const unit = drawn.unit.value;
  // Those with a sign cross 0.
  const step = firstIn(unit);
  const place = { step, min: -Infinity };
  // An arc rises at most as a half circle.
  const most = roundedPlace(side.chord / 2);
  const lengths: [string, number, (to: number) => void, Accepted][] = [
    ['x', point.at[0], (to) => drawn.step((_, __, { at }) => (at[0] = to)), place],
    ['y', point.at[1], (to) => drawn.step((_, __, { at }) => (at[1] = to)), place],
    ['Side', side.chord, (to) => drawn.setLength(to), { isPositive: true }],
    [
      'Rise',
      side.rise,
      (to) => drawn.step((_, __, point) => (point.bulge = bulgeOf(to, side.chord))),
      { step, min: -most, max: most },
    ],
  ];
  return (
    <section class="point">
      <h3>{nameOf(spot)}</h3>
      <div class="lengths">
        {lengths.map(([name, value, change, accepted]) => (
          <label key={name}>
            <span>{name}</span>
            <AmountField
              name={name}
              unit={unit}
              {...accepted}
              value={roundedPlace(value)}
              onAmount={change}
            />
            <span class="unit">{unit}</span>
          </label>
        ))}
      </div>
      {spot.loop === 0 && (
        <Checkbox
          label="Corner of the roof"
          checked={point.corner ?? false}
          onCheck={(corner) => drawn.step((_, __, point) => (point.corner = corner))}
        />
      )}
      <div class="dialog-buttons">
        <Button
          title="In the middle of the side that begins at this point"
          onClick={() => drawn.insertPoint()}
        >
          Add a point
        </Button>
        <Button
          disabled={drawn.loops.value[spot.loop].length <= 3}
          onClick={() => drawn.removePoint()}
        >
          Delete
        </Button>
        {spot.loop > 0 && <Button onClick={() => drawn.removeHole()}>Delete the hole</Button>}
      </div>
    </section>
  );
}

/** The sizes of the whole plan. Typing into one of them is a single undo step. */
function Sizes({ drawn }: { drawn: DrawnPlan }) {
  const isTyped = useRef(false);
  const plan = drawn.plan.value;
  return (
    <div
      class="sizes"
      onFocusIn={() => {
        isTyped.current = false;
      }}
    >
      {SIZES.filter(({ id }) => id !== 'turn' || plan.layout === 'cut').map((size) => (
        <SizeField
          key={`${size.id} ${drawn.replaced.value}`}
          size={size}
          value={roundedPlace(plan[size.id])}
          unit={drawn.unit.value}
          onSize={(value, problem) => {
            drawn.problems.value = { ...drawn.problems.value, [size.label]: problem };
            if (problem) return;
            if (!isTyped.current) drawn.remember();
            isTyped.current = true;
            drawn.edit((plan) => (plan[size.id] = value));
          }}
        />
      ))}
    </div>
  );
}
