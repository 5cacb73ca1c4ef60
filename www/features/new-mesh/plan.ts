/** A plan that is being drawn: its loops, the selected point, and earlier plans to go back to. */

import { computed, signal } from '@preact/signals';
import { getItem, setItem } from '../../ui/safe-storage.ts';
import { metresOf, rounded } from '../../ui/words.ts';
import {
  drawnPlan,
  endOfSide,
  firstPlan,
  loopThrough,
  newPlan,
  scaledPlan,
  type PlanPoint,
} from '../../pkg/engine/shape_up.js';

export type Plan = Required<import('../../pkg/engine/shape_up.js').Plan>;
export type Place = [number, number];

/** Loop (0: outline) and point in it. */
export type Spot = { loop: number; point: number };

/** A loop that is being drawn. */
export interface Sketch {
  of: 'outline' | 'hole';
  places: Place[];
  /** the next one, under the pointer */
  pointer: Place | null;
}

/** The choice of a plan, which is no kind of the solver. */
export const PLAN = { id: 'plan', label: 'From a plan' };

/** Maximum number of undo steps. */
const MOST_STEPS = 100;
const DIGITS = 6;
/** Storage key of the plan that was last kept, in metres. */
const LAST = 'shape-up.plan';

/** The length of a unit in metres; of an unknown one as of a metre. */
export const metresOrOne = (symbol: string) => metresOf(symbol) ?? 1;

export const roundedPlace = (value: number) => rounded(value, DIGITS);

export const nameOf = ({ loop, point }: Spot) =>
  `Point ${point + 1} of ${loop ? `hole ${loop}` : 'the outline'}`;

const scaled = (plan: Plan, factor: number) => scaledPlan(plan, factor) as Plan;

/** The plan kept last, in metres, or null. */
function lastPlan(): Plan | null {
  try {
    const plan = JSON.parse(getItem(LAST) ?? 'null');
    return plan && scaled(plan, 1);
  } catch {
    return null;
  }
}

export class DrawnPlan {
  readonly plan;
  readonly unit;
  readonly loops = computed(() => [this.plan.value.outline, ...this.plan.value.holes]);
  readonly sides = computed(() => drawnPlan(this.loops.value));
  /** The selected point, which there is in the plan. */
  readonly selected = computed<Spot>(() => {
    const { loop, point } = this.#selected.value;
    return this.loops.value[loop]?.[point] ? { loop, point } : { loop: 0, point: 0 };
  });
  readonly sketch = signal<Sketch | null>(null);
  /** What is dragged: a point, or the side that begins there. Any other change of the plan ends it. */
  readonly drag = signal<{ spot: Spot; arc: boolean; moved: boolean; pointer: number } | null>(
    null,
  );
  /** Sides that cross, given by their start points. */
  readonly crossing = signal<Spot[]>([]);
  /** What is wrong with a field of the whole plan, by its label. */
  readonly problems = signal<Record<string, string>>({});
  /** Counts the times that the plan was replaced, and not by typing. */
  readonly replaced = signal(0);
  /** Earlier plans. */
  readonly steps = signal<Plan[]>([]);
  /** Whether the drawing gets the focus: the selected point, or the loop that is drawn. */
  wantsFocus = false;
  #selected = signal<Spot>({ loop: 0, point: 0 });

  constructor(unit: string) {
    const metre = 1 / metresOrOne(unit);
    const last = lastPlan();
    this.unit = signal(unit);
    this.plan = signal<Plan>(last ? scaled(last, metre) : (firstPlan(metre) as Plan));
  }

  select(spot: Spot) {
    this.#selected.value = spot;
  }

  /** The selected point, and the side that begins there. */
  now() {
    const { loop, point } = this.selected.value;
    return { point: this.loops.value[loop][point], side: this.sides.value.loops[loop][point] };
  }

  remember() {
    this.steps.value = [...this.steps.value, this.plan.value].slice(-MOST_STEPS);
  }

  /** @param change is given a plan to change, its selected loop, and the selected point */
  edit(change: (plan: Plan, points: PlanPoint[], point: PlanPoint) => unknown) {
    const plan = structuredClone(this.plan.value);
    const { loop, point } = this.selected.value;
    const points = [plan.outline, ...plan.holes][loop];
    change(plan, points, points[point]);
    this.plan.value = plan;
  }

  /** Changes the plan in one undo step. */
  step(change: Parameters<DrawnPlan['edit']>[0]) {
    this.drag.value = null;
    this.remember();
    this.edit(change);
  }

  /** Goes back to an earlier plan; while a loop is drawn, to its point before. */
  undo() {
    const sketch = this.sketch.value;
    if (sketch) {
      const places = sketch.places.slice(0, -1);
      this.sketch.value = sketch.places.length > 0 ? { ...sketch, places } : null;
      return;
    }
    const before = this.steps.value.at(-1);
    if (!before) return;
    this.steps.value = this.steps.value.slice(0, -1);
    this.#replace(before);
  }

  startOver() {
    this.remember();
    this.#replace(firstPlan(1 / metresOrOne(this.unit.value)) as Plan);
  }

  /** Removes the selected point, unless its loop would have no area. */
  removePoint() {
    const { loop, point } = this.selected.value;
    if (this.loops.value[loop].length <= 3) return;
    this.step((_, points) => {
      points.splice(point, 1);
      this.select({ loop, point: point % points.length });
    });
    this.wantsFocus = true;
  }

  /** Adds a point in the middle of the side that begins at the selected one; an arc stays one. */
  insertPoint() {
    const { loop, point } = this.selected.value;
    const at = this.now().side.middle.map(roundedPlace) as Place;
    this.step((_, points, before) => {
      // A bulge is the tangent of a quarter of the angle of its arc.
      const bulge = Math.tan(Math.atan(before.bulge ?? 0) / 2);
      before.bulge = bulge;
      points.splice(point + 1, 0, { at, bulge, corner: false });
    });
    this.select({ loop, point: point + 1 });
    this.wantsFocus = true;
  }

  removeHole() {
    const { loop } = this.selected.value;
    this.step(({ holes }) => holes.splice(loop - 1, 1));
    this.select({ loop: 0, point: 0 });
  }

  /** Moves the end of the selected side. */
  setLength(length: number) {
    const { loop, point } = this.selected.value;
    const end = endOfSide(this.loops.value, loop, point, length);
    if (end) this.step((_, points) => (points[(point + 1) % points.length].at = [end[0], end[1]]));
  }

  beginSketch(of: Sketch['of']) {
    this.sketch.value = { of, places: [], pointer: null };
    this.wantsFocus = true;
  }

  /** Puts the loop that is drawn into the plan, if it has an area. */
  closeSketch() {
    const { of, places } = this.sketch.value ?? { of: 'outline', places: [] };
    if (places.length < 3) return;
    const points = loopThrough(Float64Array.from(places.flat()), of === 'outline');
    const corners = points.filter(({ corner }) => corner).length;
    const { plan } = this;
    this.remember();
    const holes = of === 'hole' ? [...plan.value.holes, points] : [];
    this.endSketch();
    this.#replace({
      ...plan.value,
      ...(of === 'outline' && { outline: points }),
      holes,
      layout: of === 'outline' && corners === 4 ? 'follow' : 'cut',
    });
    this.select({ loop: holes.length, point: 0 });
  }

  /** Ends drawing; the points so far are dropped. */
  endSketch() {
    this.sketch.value = null;
    this.wantsFocus = true;
  }

  /** Converts the plan, what is drawn and the earlier plans to another unit. */
  convert(unit: string) {
    if (unit === this.unit.value) return;
    const factor = metresOrOne(this.unit.value) / metresOrOne(unit);
    const moved = ([x, y]: Place): Place => [factor * x, factor * y];
    const sketch = this.sketch.value;
    this.unit.value = unit;
    this.steps.value = this.steps.value.map((plan) => scaled(plan, factor));
    this.sketch.value = sketch && { ...sketch, places: sketch.places.map(moved), pointer: null };
    this.#replace(scaled(this.plan.value, factor));
  }

  /**
   * Returns the surface over the plan.
   * @throws why there is none; sides that cross are marked
   */
  mesh() {
    const [wrong] = Object.entries(this.problems.value).filter(([, problem]) => problem);
    if (wrong) throw new Error(wrong.join(': '));
    try {
      const made = newPlan(this.plan.value, this.unit.value);
      this.crossing.value = [];
      return made;
    } catch (error) {
      const { sides = [] } = error as { sides?: number[] };
      const [a, b, c, d] = sides;
      const both = [
        { loop: a, point: b },
        { loop: c, point: d },
      ];
      this.crossing.value = d === undefined ? [] : both;
      throw error;
    }
  }

  /** Stores the plan as the start of the next one. */
  keep() {
    setItem(LAST, JSON.stringify(scaled(this.plan.value, metresOrOne(this.unit.value))));
  }

  #replace(plan: Plan) {
    this.drag.value = null;
    this.plan.value = plan;
    this.problems.value = {};
    this.replaced.value += 1;
  }
}
