/** The form of a plan: an outline drawn or typed, its division into panels, and its height. */

import './plan.css';
import { button, checkbox, choice } from '../../ui/controls/fields.ts';
import { sizeField } from '../../ui/controls/size-field.ts';
import { element, setText } from '../../ui/dom.ts';
import { planDrawing, type Place, type Spot } from './plan-drawing.ts';
import { getItem, setItem } from '../../ui/safe-storage.ts';
import {
  bulgeOf,
  drawnPlan,
  endOfSide,
  firstPlan,
  loopThrough,
  scaledPlan,
} from '../../pkg/engine/shape_up.js';
import type { Size } from '../../pkg/engine/shape_up.js';

type Plan = Required<import('../../pkg/engine/shape_up.js').Plan>;

const HINT = 'Drag points; pull the middle of a side to make it an arc. Hold Alt to move freely.';
const DRAW_HINT =
  'Click or tap to place points, and the first one again to close the loop. Undo removes the last point.';
/** Maximum number of undo steps. */
const MOST_STEPS = 100;
const DIGITS = 6;
/** Limits of a length in the plan. */
const LENGTH = { of: 'length', least: 1e-6, most: 1e6 } as const;

/** Storage key of the plan that was last kept, in metres. */
const LAST = 'shape-up.plan';

/**
 * The plan kept last, or null.
 * @param metre in the unit
 */
function lastPlan(metre: number): Plan | null {
  try {
    const plan = JSON.parse(getItem(LAST) ?? 'null');
    return plan && scaled(plan, metre);
  } catch {
    return null;
  }
}

const scaled = (plan: Plan, factor: number) => scaledPlan(plan, factor) as Plan;

const rounded = (value: number) => Number(value.toPrecision(DIGITS));

/** A length field whose value is applied on change. */
function lengthField(name: string, onchange: (value: number) => void) {
  const field = element('input', {
    ...{ type: 'number', step: 'any', inputmode: 'decimal', 'aria-label': name },
    onchange: () => (field.value !== '' ? onchange(field.valueAsNumber) : show(shown)),
  });
  const unit = element('span.unit');
  let shown = 0;
  function show(value: number) {
    shown = value;
    field.value = String(rounded(value));
  }
  const label = element('label', element('span', name), field, unit);
  return { label, show, unit };
}

/** @param given.metre in that unit */
export function planForm({
  unit,
  metre,
  onchange,
  make,
}: {
  unit: string;
  metre: number;
  onchange: () => void;
  make: (plan: Plan, units: string) => { text: string; supports: number[] };
}) {
  let plan = lastPlan(metre) ?? (firstPlan(metre) as Plan);
  let selected: Spot = { loop: 0, point: 0 };
  /** Earlier plans. */
  const steps: Plan[] = [];
  /** The kind of loop being drawn. */
  let drawn: 'outline' | 'hole' = 'outline';

  const drawing = planDrawing({
    select(spot) {
      selected = spot;
      show();
    },
    begin: remember,
    change: (spot, point) => edit(() => Object.assign(loops()[spot.loop][spot.point], point)),
    remove: removePoint,
    drawn(places) {
      remember();
      const points = loopThrough(Float64Array.from(places.flat()), drawn === 'outline');
      if (drawn === 'hole') {
        plan.holes.push(points);
        plan.layout = 'cut';
      } else {
        plan.outline = points;
        plan.holes = [];
        plan.layout = points.filter(({ corner }) => corner).length === 4 ? 'follow' : 'cut';
      }
      selected = { loop: drawn === 'hole' ? plan.holes.length : 0, point: 0 };
      changed();
    },
    hint: (words) => setText(hint, words),
  });

  const loops = () => [plan.outline, ...plan.holes];
  const points = () => loops()[selected.loop];
  const selectedSide = () => drawnPlan(loops()).loops[selected.loop][selected.point];

  function remember() {
    steps.push(structuredClone(plan));
    steps.splice(0, steps.length - MOST_STEPS);
  }

  function edit(change: () => unknown) {
    change();
    changed();
  }

  /** Changes the plan in one undo step. */
  function step(change: () => unknown) {
    remember();
    edit(change);
  }

  function changed() {
    show();
    onchange();
  }

  function undo() {
    if (drawing.isDrawing()) {
      drawing.back();
      return show();
    }
    const before = steps.pop();
    if (!before) return;
    plan = before;
    changed();
  }

  function removePoint({ loop, point }: Spot) {
    const all = loops()[loop];
    if (all.length <= 3) return;
    step(() => {
      all.splice(point, 1);
      selected = { loop, point: point % all.length };
    });
    drawing.focus();
  }

  function insertPoint() {
    step(() => {
      const { middle } = selectedSide();
      const at = middle.map(rounded) as Place;
      points()[selected.point].bulge = 0;
      points().splice(selected.point + 1, 0, { at, bulge: 0, corner: false });
      selected = { ...selected, point: selected.point + 1 };
    });
    drawing.focus();
  }

  /**
   * Moves the end of the selected side.
   * @param length new length
   */
  function setLength(length: number) {
    const end = endOfSide(loops(), selected.loop, selected.point, length);
    if (!end) return show();
    const next = points()[(selected.point + 1) % points().length];
    step(() => (next.at = [end[0], end[1]]));
  }

  function begin(what: 'outline' | 'hole') {
    drawn = what;
    drawing.draw();
    show();
    setText(hint, DRAW_HINT);
  }

  const hint = element('p.quiet.hint', HINT);
  const which = element('h3');
  const selectedPoint = () => points()[selected.point];
  const x = lengthField('x', (value) => step(() => (selectedPoint().at[0] = value)));
  const y = lengthField('y', (value) => step(() => (selectedPoint().at[1] = value)));
  const length = lengthField('Side', setLength);
  const rise = lengthField('Rise', (value) =>
    step(() => (selectedPoint().bulge = bulgeOf(value, selectedSide().chord))),
  );
  const lengths = [x, y, length, rise];
  const corner = checkbox('Corner of the roof', (checked) =>
    step(() => (selectedPoint().corner = checked)),
  );
  const insert = button('Add a point', insertPoint, {
    title: 'In the middle of the side that begins at this point',
  });
  const remove = button('Delete', () => removePoint(selected));
  const removeHole = button('Delete the hole', () => {
    const { loop } = selected;
    selected = { loop: 0, point: 0 };
    step(() => plan.holes.splice(loop - 1, 1));
  });
  const back = button('Undo', undo);

  const layout = choice({}, (value) => step(() => (plan.layout = value as Plan['layout'])), [
    ['follow', 'Along the outline'],
    ['cut', 'A grid, cut to fit'],
  ]);
  const stands = choice({}, (value) => step(() => (plan.stands = value as Plan['stands'])), [
    ['corners', 'Its corners'],
    ['outline', 'The whole outline'],
  ]);
  // Typing into one field is a single undo step.
  let isTyped = false;
  const sizes = element('div.sizes');
  sizes.addEventListener('focusin', () => (isTyped = false));
  function type(change: () => unknown) {
    if (!isTyped) remember();
    isTyped = true;
    back.disabled = false;
    change();
  }

  /** Builds the fields of the whole plan, anew whenever the plan is replaced. */
  function showSizes() {
    const field = (id: 'size' | 'height' | 'turn', label: string, limits: Partial<Size>) => {
      const size = { label, ...LENGTH, ...limits };
      const made = sizeField(size, {
        value: rounded(plan[id]),
        unit,
        onchange: () => {
          const input = made.querySelector('input');
          if (input?.validity.valid) type(() => (plan[id] = input.valueAsNumber));
          onchange();
        },
      });
      return made;
    };
    sizes.replaceChildren(
      field('size', 'Panel', {}),
      field('height', 'Height', { least: 0 }),
      ...(plan.layout === 'cut'
        ? [field('turn', 'Turned by', { of: 'degrees', least: -180, most: 180 })]
        : []),
    );
  }

  function show() {
    if (!points()?.[selected.point]) selected = { loop: 0, point: 0 };
    const { loop } = selected;
    const shown = drawnPlan(loops());
    const { chord, rise: height } = shown.loops[loop][selected.point];
    const { at, corner: isCorner } = selectedPoint();
    setText(which, `Point ${selected.point + 1} of ${loop ? `hole ${loop}` : 'the outline'}`);
    [at[0], at[1], chord, height].forEach((value, k) => lengths[k].show(value));
    for (const one of lengths) setText(one.unit, unit);
    corner.box.checked = Boolean(isCorner);
    corner.label.hidden = loop > 0;
    removeHole.hidden = loop === 0;
    remove.disabled = points().length <= 3;
    back.disabled = steps.length === 0 && !drawing.isDrawing();
    layout.value = plan.layout;
    stands.value = plan.stands;
    if (!drawing.isDrawing()) setText(hint, HINT);
    drawing.show(loops(), shown, selected, unit);
    const isFocused = sizes.contains(document.activeElement);
    if (!isFocused) showSizes();
  }

  const form = element(
    'div.plan',
    element(
      'div.dialog-buttons',
      button('Draw the outline', () => begin('outline')),
      button('Draw a hole', () => begin('hole')),
      button('Start over', () => step(() => (plan = firstPlan(metre) as Plan))),
      back,
    ),
    drawing.element,
    hint,
    element(
      'section.point',
      which,
      element('div.lengths', ...lengths.map(({ label }) => label)),
      corner.label,
      element('div.dialog-buttons', insert, remove, removeHole),
    ),
    element('label', element('span', 'Panels'), layout),
    element('label', element('span', 'Stands on'), stands),
    sizes,
  );
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && drawing.isDrawing()) {
      event.preventDefault();
      drawing.stop();
      show();
    }
    // A number field has an undo of its own.
    const isText = event.target instanceof HTMLInputElement && event.target.type === 'number';
    if (event.key === 'z' && (event.ctrlKey || event.metaKey) && !isText) {
      event.preventDefault();
      undo();
    }
  });

  return {
    element: form,
    show,
    made(units: string) {
      try {
        const surface = make(plan, units);
        drawing.mark([]);
        return surface;
      } catch (error) {
        const [a, b, c, d] = (error as { sides?: number[] }).sides ?? [];
        const crossing =
          d === undefined
            ? []
            : [
                [a, b],
                [c, d],
              ];
        drawing.mark(crossing.map(([loop, point]) => ({ loop, point })));
        throw error;
      }
    },
    /** Stores the plan as the start of the next one. */
    kept: () => setItem(LAST, JSON.stringify(scaled(plan, 1 / metre))),
    /** Converts the plan to another unit. */
    convert(symbol: string, factor: number) {
      unit = symbol;
      metre *= factor;
      plan = scaled(plan, factor);
      steps.length = 0;
      show();
    },
  };
}
