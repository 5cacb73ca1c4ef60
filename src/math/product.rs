//! The closest numbers with a given product: the singular values of a triangle of given area, or of
//! a tetrahedron of given volume, that change least.
//!
//! If the `s_i` are the closest to the `a_i`, Lagrange's condition is `s_i (s_i - a_i) = m` with
//! the same `m` for all. By the second-order condition (`2 s_i - a_i` is negative for at most one
//! of them), all but the last `s_i` are the greater root of that equation, and the last one, `t`,
//! determines `m`. One equation in one unknown remains. It is convex where Newton's method comes
//! from above, so that it never overshoots.

use crate::math::Lane;

/// Steps in lanes. Each Newton step doubles the number of correct digits.
const STEPS: usize = 8;

/// Steps of the robust functions. Towards a triple root each step reduces the error by a third.
const MANY_STEPS: usize = 100;

/// Returns the `s >= t >= 0` with `s t = root^2` that are closest to `a >= b >= 0`, and one in the
/// lanes where they are accurate to about 1e-14, else zero. Fourth powers must be in the range of
/// `f64`.
#[inline(always)]
pub fn pair_with_product<S: Lane>(a: S, b: S, root: S) -> ([S; 2], S) {
    let pair = Pair::new(a, b, root);
    let mut s = pair.start();
    let mut accurate = S::zero();
    for _ in 0..STEPS {
        let (step, slope) = pair.step(s);
        let close = (S::splat(1e-8) * s).if_greater(step.abs(), S::one(), S::zero());
        accurate = slope.if_greater(S::splat(1e-3) * s * s * s, close, S::zero());
        s -= step;
    }
    ([s, pair.product / s], accurate)
}

/// The same for every input whose fourth powers are in the range of `f64`.
pub fn pair_with_product_robust(a: f64, b: f64, root: f64) -> [f64; 2] {
    let pair = Pair::new(a, b, root);
    let mut s = pair.start();
    if s == 0.0 {
        return [0.0; 2];
    }
    for _ in 0..MANY_STEPS {
        let next = s - pair.step(s).0;
        // Decreases until only rounding error is left.
        if next < s {
            s = next;
        } else {
            break;
        }
    }
    [s, pair.product / s]
}

/// The greatest root of `s^4 - a s^3 + p b s - p^2`, which is `s (s - a) = t (t - b)` times `s^2`
/// with `p = s t`.
struct Pair<S> {
    a: S,
    b: S,
    root: S,
    product: S,
}

impl<S: Lane> Pair<S> {
    #[inline(always)]
    fn new(a: S, b: S, root: S) -> Self {
        Pair { a, b, root, product: root * root }
    }

    /// An upper bound of the root: both `a + root` and the greater of `a` and `p / b` are.
    #[inline(always)]
    fn start(&self) -> S {
        // If the quotient is 0 / 0, the maximum is `a`.
        (self.product / self.b).max(self.a).min(self.a + self.root)
    }

    /// Newton's step and the slope.
    #[inline(always)]
    fn step(&self, s: S) -> (S, S) {
        let (p, square) = (self.product, s * s);
        let value = square * s * (s - self.a) + p * (self.b * s - p);
        let slope = square * (S::splat(4.0) * s - S::splat(3.0) * self.a) + p * self.b;
        (value / slope, slope)
    }
}

/// Returns the non-negative `s` with the product `root^3` that are closest to `a[0] >= a[1] >=
/// |a[2]|`, and one in the lanes where they are accurate to about 1e-14, else zero: there the
/// product falls to less than half, or to zero. Cubes must be in the range of `f64`.
#[inline(always)]
pub fn triple_with_product<S: Lane>(a: [S; 3], root: S) -> ([S; 3], S) {
    let target = root * root * root;
    let product = a[0] * a[1] * a[2];
    let greater = (target / (a[0] * a[1])).min(root);
    let mut t = target.if_greater(product, greater, a[2]);
    let mut accurate = S::zero();
    for _ in 0..STEPS {
        let triple = Triple::at(a, t);
        let step = (triple.product() - target) / triple.slope();
        accurate = (S::splat(1e-8) * t).if_greater(step.abs(), S::one(), S::zero());
        t -= step;
    }
    let accurate = target.if_greater(S::splat(0.5) * product, accurate, S::zero());
    let Triple { s: [first, second], .. } = Triple::at(a, t);
    ([first, second, t], accurate)
}

/// The same for every input whose cubes are in the range of `f64`.
pub fn triple_with_product_robust(a: [f64; 3], root: f64) -> [f64; 3] {
    let target = root * root * root;
    let product = a[0] * a[1] * a[2];
    if target >= product {
        let start = if target == 0.0 { 0.0 } else { (target / (a[0] * a[1])).min(root) };
        return from_above(a, start, target);
    }
    // If the product falls a lot, the last number may be either root of its equation. If the
    // product at half of it exceeds the target, the smaller root exists for sure; else the greater
    // one does.
    let half = 0.5 * a[2];
    if Triple::at(a, half).product() > target {
        return from_below(a, target, true).expect("the root is between zero and half of the last");
    }
    let greater = from_above(a, a[2], target);
    let distance = |s: [f64; 3]| -> f64 { (0..3).map(|i| (s[i] - a[i]) * (s[i] - a[i])).sum() };
    match from_below(a, target, false) {
        Some(smaller) if distance(smaller) < distance(greater) => smaller,
        _ => greater,
    }
}

/// Newton's method from a `start` not below the greater root, down to it.
fn from_above(a: [f64; 3], start: f64, target: f64) -> [f64; 3] {
    let mut t = start;
    for _ in 0..MANY_STEPS {
        let triple = Triple::at(a, t);
        let next = t - (triple.product() - target) / triple.slope();
        if next < t {
            t = next;
        } else {
            break;
        }
    }
    let Triple { s: [first, second], .. } = Triple::at(a, t);
    [first, second, t]
}

/// Newton's method from below, up to the smaller root, which is below half of `a[2]`. Returns
/// `None` if the product does not reach the target on the way; if it is `known` to, steps that
/// leave the bracket are replaced by bisection.
fn from_below(a: [f64; 3], target: f64, known: bool) -> Option<[f64; 3]> {
    let (mut low, mut high) = (0.0, 0.5 * a[2]);
    let mut t = (target / (a[0] * a[1])).min(high);
    for _ in 0..MANY_STEPS {
        let triple = Triple::at(a, t);
        let (short, slope) = (target - triple.product(), triple.slope());
        if short > 0.0 {
            low = t;
        } else {
            high = t;
        }
        let mut next = t + short / slope;
        if !(low..=high).contains(&next) || slope <= 0.0 {
            if !known {
                return None;
            }
            next = 0.5 * (low + high);
        }
        if (next - t).abs() <= f64::EPSILON * t {
            break;
        }
        t = next;
    }
    let Triple { s: [first, second], .. } = Triple::at(a, t);
    Some([first, second, t])
}

/// The three numbers as functions of the last one, `t`.
struct Triple<S> {
    /// The first two.
    s: [S; 2],
    /// Their derivatives.
    rates: [S; 2],
    t: S,
}

impl<S: Lane> Triple<S> {
    #[inline(always)]
    fn at(a: [S; 3], t: S) -> Self {
        let along = t + t - a[2];
        // s (s - a) = t (t - a[2]), in a form without differences of squares.
        let root = |a_i: S| ((a_i - a[2]) * (a_i + a[2]) + along * along).max(S::zero()).sqrt();
        let roots = [root(a[0]), root(a[1])];
        // The derivative is one at the corner, where the root vanishes.
        let rate = |root: S| root.if_greater(S::zero(), along / root, S::one());
        Triple {
            s: [(a[0] + roots[0]) * S::splat(0.5), (a[1] + roots[1]) * S::splat(0.5)],
            rates: roots.map(rate),
            t,
        }
    }

    #[inline(always)]
    fn product(&self) -> S {
        self.s[0] * self.s[1] * self.t
    }

    #[inline(always)]
    fn slope(&self) -> S {
        let [first, second] = self.s;
        first * second + self.t * (self.rates[0] * second + self.rates[1] * first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: [f64; 9] = [0.0, 1e-9, 1e-3, 0.2, 0.7, 0.999, 1.0, 1.3, 40.0];

    /// The minimum of `f` over numbers evenly spaced in their logarithm, refined.
    fn least(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
        let (mut from, mut to) = (from, to);
        for _ in 0..12 {
            let ratio = (to / from).sqrt().sqrt().sqrt().sqrt().sqrt();
            let at = |k: i32| from * ratio.powi(k);
            let best = (0..=32).min_by(|j, k| f(at(*j)).total_cmp(&f(at(*k)))).expect("33 of them");
            (from, to) = (at((best - 1).max(0)), at((best + 1).min(32)));
        }
        f((from * to).sqrt())
    }

    #[test]
    fn a_pair_is_as_close_as_a_search_finds() {
        for a in SIZES {
            for b in SIZES.into_iter().filter(|b| *b <= a) {
                for root in SIZES {
                    let p = root * root;
                    let distance = |s: f64, t: f64| (s - a) * (s - a) + (t - b) * (t - b);
                    let [s, t] = pair_with_product_robust(a, b, root);
                    assert!((s * t - p).abs() <= 1e-14 * p.max(1e-3), "{a} {b} {root}: {s} {t}");
                    let found = distance(s, t);
                    if p > 0.0 {
                        let least = least(1e-12, 1e3, |s| distance(s, p / s));
                        let slack = 1e-13 * (a * a + p);
                        assert!(found <= least + slack, "{a} {b} {root}: {found:e}, {least:e}");
                    } else {
                        assert!(found <= b * b * (1.0 + 1e-14), "{a} {b}: {found}");
                    }
                    let (fast, accurate) = pair_with_product(a, b, root);
                    if accurate > 0.0 {
                        let error = (fast[0] - s).abs().max((fast[1] - t).abs());
                        assert!(error <= 1e-12 * s, "{a} {b} {root}: off by {error:e}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_triple_is_as_close_as_a_search_finds() {
        let (mut fast_ones, mut all) = (0, 0);
        for a in SIZES.into_iter().filter(|a| *a > 1e-6) {
            for b in SIZES.into_iter().filter(|b| *b <= a) {
                for c in SIZES.into_iter().flat_map(|c| [-c, c]).filter(|c| c.abs() <= b) {
                    for root in SIZES {
                        let target = root * root * root;
                        let distance = |s: f64, t: f64, u: f64| {
                            (s - a) * (s - a) + (t - b) * (t - b) + (u - c) * (u - c)
                        };
                        let [s, t, u] = triple_with_product_robust([a, b, c], root);
                        let name = format!("{a} {b} {c} {root}: {s} {t} {u}");
                        assert!((s * t * u - target).abs() <= 1e-13 * target, "{name}");
                        let found = distance(s, t, u);
                        if target > 0.0 {
                            let least = least(1e-12, 1e3, |u| {
                                let p = target / u;
                                let [s, t] = pair_with_product_robust(a, b, p.sqrt());
                                distance(s, t, u)
                            });
                            let slack = 1e-12 * (a * a + root * root);
                            assert!(found <= least + slack, "{name}: {found:e}, {least:e}");
                        } else {
                            assert!(found <= c * c * (1.0 + 1e-14), "{name}");
                        }
                        let (fast, accurate) = triple_with_product([a, b, c], root);
                        all += 1;
                        if accurate > 0.0 {
                            fast_ones += 1;
                            let off = [fast[0] - s, fast[1] - t, fast[2] - u];
                            let error = off.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                            assert!(error <= 1e-11 * s, "{name}: off by {error:e}");
                        }
                    }
                }
            }
        }
        assert!(2 * fast_ones > all, "{fast_ones} of {all} are fast");
    }

    #[test]
    fn three_equal_numbers_fall_together_or_one_by_itself() {
        let together = triple_with_product_robust([1.0; 3], 0.6);
        assert!(together.iter().all(|s| (s - 0.6).abs() <= 1e-14), "{together:?}");
        let [s, t, u] = triple_with_product_robust([1.0; 3], 0.4);
        assert!((s - t).abs() <= 1e-14 && u < 0.1 && s > 0.9, "{s} {t} {u}");
    }
}
