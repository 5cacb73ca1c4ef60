//! The circle or sphere of a given radius that is closest to points, wherever these are.
//!
//! The centre `c` minimises `E = mean (|v - c| - r)^2`, which has several minima: points all around
//! a smaller circle are closest to one that has them on one side, and coplanar points bulge to
//! either side of a sphere. Newton's method with a decreasing `E` therefore begins at several
//! places, and the best result counts. With `w = c - v` and `u = w / |w|`,
//!
//! ```text
//! gradient  mean (|w| - r) u,    Hessian  mean (u u^T + k (I - u u^T)),   k = 1 - r / |w|
//! ```

use crate::math::{Round, Symmetric3, Vec3, key_of_number, sort_by_number};

/// Newton's method converges in some ten steps; in a third as many digits a step where the Hessian
/// vanishes at the minimum, as for an arc of a great circle.
const STEPS: usize = 60;

/// Steps from every start, after which it shows which of them lead to the least energies.
const FIRST_STEPS: usize = 2;

/// Number of starts with the least energies that are followed to their end.
const FOLLOWED: usize = 2;

/// A step is halved at most so often; what then does not descend is rounding error.
const HALVINGS: usize = 12;

/// Added to the Hessian without its negative parts, so that it is invertible.
const REGULARISATION: f64 = 1e-12;

/// Steps longer than this fraction of the radius change `E` by more than its rounding error.
const POLISH: f64 = 1e-6;

/// A later start wins only if it is better than this: symmetric points have equal minima.
const BETTER: f64 = 1.0 - 1e-9;

/// Mean squared distances below this, relative to the squared radius, are rounding error.
const ROUNDING: f64 = 1e-30;

/// Returns the centre of the circle (two `dimensions`) or sphere (three) with this `radius` that is
/// closest to points in principal coordinates, of which the first `dimensions` count. `first` is
/// where the search begins; other centres replace its result only if they are better.
pub(super) fn nearest_centre(
    points: &[Vec3<f64>],
    dimensions: usize,
    radius: f64,
    first: Vec3<f64>,
) -> Vec3<f64> {
    let search = Search { points, dimensions, radius };
    let enough = ROUNDING * radius * radius;
    let mut best = search.descend(first, STEPS);
    if best.0 > enough {
        let begun = search.starts().into_iter().map(|start| search.descend(start, FIRST_STEPS));
        let mut others: Vec<(f64, Vec3<f64>)> = begun.collect();
        sort_by_number(&mut others, |other| key_of_number(other.0));
        others.truncate(FOLLOWED);
        for (_, start) in others {
            let found = search.descend(start, STEPS);
            if found.0 < BETTER * best.0 - enough {
                best = found;
            }
        }
    }
    search.polished(best.1)
}

struct Search<'a> {
    points: &'a [Vec3<f64>],
    dimensions: usize,
    radius: f64,
}

impl Search<'_> {
    /// The centres from which a circle or sphere passes through the mean of the points, in many
    /// directions; and for a sphere those that have the circle of the points in their plane.
    fn starts(&self) -> Vec<Vec3<f64>> {
        let mut starts = Vec::new();
        if self.dimensions == 3 {
            let circle = Round::fit_principal(self.points, 2);
            if let Some((centre, radius)) = circle.centre_and_radius() {
                let height = (self.radius * self.radius - radius * radius).max(0.0).sqrt();
                starts.extend([height, -height].map(|z| Vec3::new(centre.x, centre.y, z)));
            }
        }
        let signs = [1.0, -1.0, 0.0];
        let along_third: &[f64] = if self.dimensions == 3 { &signs } else { &[0.0] };
        for z in along_third {
            for y in signs {
                for x in signs {
                    let direction = Vec3::new(x, y, *z);
                    let length = direction.length();
                    if length > 0.0 {
                        starts.push(direction * (self.radius / length));
                    }
                }
            }
        }
        starts
    }

    /// Returns the least `E` that so many of Newton's steps find from `start`, and where it is.
    fn descend(&self, start: Vec3<f64>, steps: usize) -> (f64, Vec3<f64>) {
        let mut best = (self.energy(start), start);
        for _ in 0..steps {
            let step = self.step(best.1);
            if step.length() <= POLISH * self.radius {
                break;
            }
            let lower = (0..HALVINGS)
                .map(|k| best.1 + step * 0.5f64.powi(k as i32))
                .map(|centre| (self.energy(centre), centre))
                .find(|(energy, _)| *energy < best.0);
            let Some(lower) = lower else { break };
            best = lower;
        }
        best
    }

    /// Newton's steps for the digits that `E`, which is flat at its minimum, does not show.
    fn polished(&self, mut centre: Vec3<f64>) -> Vec3<f64> {
        let mut longest = POLISH * self.radius;
        for _ in 0..STEPS {
            let step = self.step(centre);
            let length = step.length();
            if !(length > 0.0 && length <= longest) {
                break;
            }
            centre += step;
            longest = 0.5 * length;
        }
        centre
    }

    /// The difference of distance and radius, as in `RoundWithin::limited_step`.
    fn excess(&self, v: Vec3<f64>, centre: Vec3<f64>) -> f64 {
        let r = self.radius;
        let square = centre.length_squared() - r * r + (v.length_squared() - 2.0 * v.dot(centre));
        square / ((v - centre).length() + r)
    }

    fn energy(&self, centre: Vec3<f64>) -> f64 {
        let sum: f64 = self.points.iter().map(|v| self.excess(*v, centre).powi(2)).sum();
        // A start that is no number loses against all others.
        if sum.is_nan() { f64::INFINITY } else { sum / self.points.len() as f64 }
    }

    /// Newton's step at this centre; without the negative parts of the Hessian where it is not
    /// positive definite.
    fn step(&self, centre: Vec3<f64>) -> Vec3<f64> {
        let mut gradient = Vec3::zero();
        // Of `(1 - k) u u^T` and `k`, of which the Hessian is the sum; and of what is negative.
        let (mut whole, mut negative) = ([0.0; 7], [0.0; 7]);
        for v in self.points {
            let w = centre - *v;
            let distance = w.length();
            let u = if distance > 0.0 { w * (1.0 / distance) } else { Vec3::new(1.0, 0.0, 0.0) };
            let excess = self.excess(*v, centre);
            gradient += u * excess;
            let k = if distance > 0.0 { excess / distance } else { -1.0 };
            let products = [u.x * u.x, u.x * u.y, u.x * u.z, u.y * u.y, u.y * u.z, u.z * u.z];
            let below = k.min(0.0);
            for i in 0..6 {
                whole[i] += (1.0 - k) * products[i];
                negative[i] -= below * products[i];
            }
            whole[6] += k;
            negative[6] += below;
        }
        let level = REGULARISATION * self.points.len() as f64;
        let solved = |[xx, xy, xz, yy, yz, zz, k]: [f64; 7]| {
            let zz = if self.dimensions == 2 { 1.0 } else { zz + k };
            let hessian = Symmetric3 { xx: xx + k, xy, xz, yy: yy + k, yz, zz };
            let adjugate = hessian.adjugate();
            let determinant = hessian.determinant(adjugate);
            let is_positive = hessian.xx > 0.0 && adjugate.zz > 0.0 && determinant > 0.0;
            is_positive.then(|| adjugate.times(gradient) * (-1.0 / determinant))
        };
        solved(whole)
            .filter(|step| step.length_squared() <= self.radius * self.radius)
            .or_else(|| {
                for i in 0..7 {
                    whole[i] -= negative[i];
                }
                whole[6] += level;
                solved(whole)
            })
            .unwrap_or_else(Vec3::zero)
    }
}
