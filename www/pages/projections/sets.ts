/**
 * The mathematics of the drawing after Fig. 2 and 3: constraint sets in the plane, their closest
 * points (Eq. 2), the proximity function (Eq. 1) and its two steps (section 2.1). It is independent
 * of the solver.
 */

export type Point = [number, number];

/**
 * A line through `at` along `turn`; a circle of `radius` about `at`; a parabola `y = bend x^2` with
 * its lowest point at `at`, turned by `turn`. Angles are in radians.
 */
export type ConstraintSet =
  | { kind: 'line'; at: Point; turn: number }
  | { kind: 'circle'; at: Point; radius: number }
  | { kind: 'parabola'; at: Point; turn: number; bend: number };

/** Returns the point of the set that is closest to `x`; any of them if there are several. */
export function closestPoint(set: ConstraintSet, x: Point): Point {
  const [dx, dy] = [x[0] - set.at[0], x[1] - set.at[1]];
  if (set.kind === 'circle') {
    const distance = Math.hypot(dx, dy);
    if (distance === 0) return [set.at[0] + set.radius, set.at[1]];
    const part = set.radius / distance;
    return [set.at[0] + part * dx, set.at[1] + part * dy];
  }
  const [c, s] = [Math.cos(set.turn), Math.sin(set.turn)];
  const [along, across] = [c * dx + s * dy, c * dy - s * dx];
  const [u, v] = set.kind === 'line' ? [along, 0] : closestOnParabola(set.bend, along, across);
  return [set.at[0] + c * u - s * v, set.at[1] + s * u + c * v];
}

/** @param bend not zero */
function closestOnParabola(bend: number, x: number, y: number): Point {
  // At the least distance, its derivative 2 b^2 u^3 + (1 - 2 b y) u - x is zero.
  const roots = rootsOfCubic((1 - 2 * bend * y) / (2 * bend * bend), -x / (2 * bend * bend));
  const points = roots.map((u) => [u, bend * u * u] as Point);
  const far = ([u, v]: Point) => (u - x) ** 2 + (v - y) ** 2;
  return points.reduce((best, point) => (far(point) < far(best) ? point : best));
}

/** The real roots of `u^3 + p u + q`, by Cardano's and Viète's formulas. */
function rootsOfCubic(p: number, q: number) {
  const discriminant = (q / 2) ** 2 + (p / 3) ** 3;
  if (discriminant > 0) {
    // The cube root of larger magnitude, because the other one suffers cancellation.
    const root = Math.sqrt(discriminant);
    const large = Math.cbrt(q > 0 ? -q / 2 - root : -q / 2 + root);
    return [large - p / (3 * large)];
  }
  if (p === 0) return [0];
  const size = 2 * Math.sqrt(-p / 3);
  const turn = Math.acos(Math.max(-1, Math.min(1, (3 * q) / (p * size)))) / 3;
  return [0, 1, 2].map((k) => size * Math.cos(turn - (2 * Math.PI * k) / 3));
}

/**
 * Returns `w_i |x - y_i|^2` for each set.
 * @param targets `y_i`
 * @param weights `w_i`
 */
export function errors(x: Point, targets: Point[], weights: number[]) {
  return targets.map((y, i) => weights[i] * ((x[0] - y[0]) ** 2 + (x[1] - y[1]) ** 2));
}

export const sum = (numbers: number[]) => numbers.reduce((total, one) => total + one, 0);

/** Step I: returns the closest point of every set. */
export const project = (sets: ConstraintSet[], x: Point) => sets.map((set) => closestPoint(set, x));

/**
 * Step II: returns the minimiser of the weighted squared distances to the targets, their weighted
 * mean; `x` if all weights are zero.
 */
export function reconcile(x: Point, targets: Point[], weights: number[]): Point {
  const total = sum(weights);
  if (!(total > 0)) return x;
  const mean = (axis: 0 | 1) => sum(targets.map((y, i) => weights[i] * y[axis])) / total;
  return [mean(0), mean(1)];
}
