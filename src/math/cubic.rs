//! A segment of a cubic curve, and its closest point.

use super::Vec3;

/// The curve `c0 + c1 t + c2 t^2 + c3 t^3` for `t` from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubic([Vec3<f64>; 4]);

impl Cubic {
    /// Returns the curve from `ends[0]` to `ends[1]` with these end derivatives (Hermite form).
    pub fn hermite(ends: [Vec3<f64>; 2], derivatives: [Vec3<f64>; 2]) -> Cubic {
        let ([a, b], [u, v]) = (ends, derivatives);
        let chord = b - a;
        Cubic([a, u, chord * 3.0 - u * 2.0 - v, u + v - chord * 2.0])
    }

    /// The point at `t`.
    pub fn point(&self, t: f64) -> Vec3<f64> {
        let [c0, c1, c2, c3] = self.0;
        c0 + (c1 + (c2 + c3 * t) * t) * t
    }

    /// The length of the control polygon, an upper bound of the length of the curve.
    pub fn length_bound(&self) -> f64 {
        let [_, c1, c2, c3] = self.0;
        let third = 1.0 / 3.0;
        let sides = [c1 * third, (c1 + c2) * third, c1 * third + c2 * (2.0 * third) + c3];
        sides.iter().map(|side| side.length()).sum()
    }

    /// Returns the point of the curve closest to `v`, or one of them if several are equally close.
    /// The minima of the distance are bracketed by zeros of its derivatives, each zero between two
    /// zeros of the next derivative, so that none is missed. Each zero is then found by Newton's
    /// method, with bisection if a step leaves the bracket.
    pub fn closest(&self, v: Vec3<f64>) -> Vec3<f64> {
        let [c0, c1, c2, c3] = self.0;
        let a = c0 - v;
        // Half the derivative of the squared distance, by ascending powers.
        let slope = [
            a.dot(c1),
            c1.dot(c1) + 2.0 * a.dot(c2),
            3.0 * (c1.dot(c2) + a.dot(c3)),
            2.0 * c2.dot(c2) + 4.0 * c1.dot(c3),
            5.0 * c2.dot(c3),
            3.0 * c3.dot(c3),
        ];
        let (zeros, n) = zeros(&slope);
        let mut best = (self.point(0.0), (c0 - v).length_squared());
        for &t in zeros[..n].iter().chain(&[1.0]) {
            let point = self.point(t);
            let distance = (point - v).length_squared();
            if distance < best.1 {
                best = (point, distance);
            }
        }
        best.0
    }
}

/// Degree of the polynomials whose zeros are found.
const DEGREE: usize = 5;
/// Enough bisections to exhaust the interval.
const MOST_STEPS: usize = 100;

/// Returns the sign changes of a polynomial between 0 and 1, ascending, and their number.
/// Coefficients are by ascending powers.
fn zeros(polynomial: &[f64; DEGREE + 1]) -> ([f64; DEGREE], usize) {
    let (mut found, mut n) = ([0.0; DEGREE], 0);
    // From the linear derivative down to the polynomial itself.
    for order in (0..DEGREE).rev() {
        let mut derivative = *polynomial;
        for _ in 0..order {
            for k in 0..DEGREE {
                derivative[k] = (k + 1) as f64 * derivative[k + 1];
            }
            derivative[DEGREE] = 0.0;
        }
        let at = |t: f64| {
            derivative
                .iter()
                .rev()
                .fold((0.0, 0.0), |(value, slope), c| (value * t + c, slope * t + value))
        };
        let (mut next, mut count) = ([0.0; DEGREE], 0);
        let mut low = 0.0;
        for high in found[..n].iter().copied().chain([1.0]) {
            if (at(low).0 < 0.0) != (at(high).0 < 0.0) {
                next[count] = zero_between(low, high, at);
                count += 1;
            }
            low = high;
        }
        (found, n) = (next, count);
    }
    (found, n)
}

/// Returns the zero of a function that is monotone between `low` and `high` and has different signs
/// there. `at` returns its value and its derivative.
fn zero_between(mut low: f64, mut high: f64, at: impl Fn(f64) -> (f64, f64)) -> f64 {
    let rises = at(low).0 < 0.0;
    let mut t = 0.5 * (low + high);
    for _ in 0..MOST_STEPS {
        let (value, slope) = at(t);
        if value == 0.0 {
            break;
        }
        if (value < 0.0) == rises {
            low = t;
        } else {
            high = t;
        }
        let newton = t - value / slope;
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        // The bracket is exhausted, or the step is rounding error.
        if next <= low || next >= high || (next - t).abs() <= f64::EPSILON {
            break;
        }
        t = next;
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudo-random numbers from -1 to 1.
    fn noise(seed: usize) -> f64 {
        ((seed * 7919 + 104_729) % 2003) as f64 / 1001.5 - 1.0
    }

    fn vector(seed: usize) -> Vec3<f64> {
        Vec3::new(noise(seed), noise(seed + 1000), noise(seed + 2000))
    }

    #[test]
    fn no_point_of_a_fine_sampling_is_closer() {
        for k in 0..400 {
            let curve = Cubic::hermite(
                [vector(4 * k), vector(4 * k + 1)],
                [vector(4 * k + 2) * 4.0, vector(4 * k + 3) * 4.0],
            );
            let v = vector(5 * k + 17) * 2.0;
            let found = (curve.closest(v) - v).length();
            let sampled = (0..=2000).map(|i| (curve.point(f64::from(i) / 2000.0) - v).length());
            let least = sampled.fold(f64::INFINITY, f64::min);
            assert!(found <= least + 1e-12, "{k}: {found} {least}");
        }
    }

    #[test]
    fn a_straight_line_a_point_and_a_place_on_the_curve_are_found() {
        let [a, b] = [Vec3::new(1.0, 2.0, 3.0), Vec3::new(3.0, 2.0, 3.0)];
        let line = Cubic::hermite([a, b], [b - a; 2]);
        let off = line.closest(Vec3::new(1.5, 7.0, 3.0)) - Vec3::new(1.5, 2.0, 3.0);
        assert!(off.length() < 1e-15);
        assert!((line.length_bound() - 2.0).abs() < 1e-12);
        let point = Cubic::hermite([a, a], [Vec3::zero(); 2]);
        assert_eq!(point.closest(b), a);
        let curve = Cubic::hermite([a, b], [vector(1) * 9.0, vector(2) * 9.0]);
        for i in 0..=100 {
            let on = curve.point(f64::from(i) / 100.0);
            assert!((curve.closest(on) - on).length() < 1e-12);
        }
    }
}
