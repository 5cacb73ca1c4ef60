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

use crate::math::{Round, Vec3};
use nalgebra::{Matrix3, Vector3};

/// Newton's method converges in some ten steps; in a third as many digits a step where the Hessian
/// vanishes at the minimum, as for an arc of a great circle.
const STEPS: usize = 60;

/// A step is halved at most so often; what then does not descend is rounding error.
const HALVINGS: usize = 30;

/// Added to the Hessian without its negative parts, so that it is invertible.
const LEVEL: f64 = 1e-12;

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
    let mut best = search.descend(first);
    for start in search.starts() {
        if best.0 <= enough {
            break;
        }
        let found = search.descend(start);
        if found.0 < BETTER * best.0 - enough {
            best = found;
        }
    }
    best.1
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

    /// Returns the least `E` that Newton's method finds from `start`, and where it is.
    fn descend(&self, start: Vec3<f64>) -> (f64, Vec3<f64>) {
        let mut best = (self.energy(start), start);
        for _ in 0..STEPS {
            let step = self.step(best.1);
            let lower = (0..HALVINGS)
                .map(|k| best.1 + step * 0.5f64.powi(k as i32))
                .map(|centre| (self.energy(centre), centre))
                .find(|(energy, _)| *energy < best.0);
            let Some(lower) = lower else { break };
            best = lower;
        }
        self.polished(best)
    }

    /// Newton's steps for the digits that `E`, which is flat at its minimum, does not show.
    fn polished(&self, (energy, mut centre): (f64, Vec3<f64>)) -> (f64, Vec3<f64>) {
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
        (energy, centre)
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
        let (mut gradient, mut along, mut across, mut positive) =
            (Vector3::zeros(), Matrix3::zeros(), Matrix3::zeros(), Matrix3::zeros());
        for v in self.points {
            let w = centre - *v;
            let distance = w.length();
            let u = if distance > 0.0 { w * (1.0 / distance) } else { Vec3::new(1.0, 0.0, 0.0) };
            let excess = self.excess(*v, centre);
            let u = Vector3::new(u.x, u.y, u.z);
            gradient += u * excess;
            let outer = u * u.transpose();
            let rest = Matrix3::identity() - outer;
            let k = if distance > 0.0 { excess / distance } else { -1.0 };
            along += outer;
            across += rest * k;
            positive += rest * k.max(0.0);
        }
        let n = self.points.len() as f64;
        let solved = |mut hessian: Matrix3<f64>| {
            hessian /= n;
            if self.dimensions == 2 {
                hessian[(2, 2)] = 1.0;
            }
            hessian.cholesky().map(|factor| factor.solve(&(-gradient / n)))
        };
        let level = Matrix3::identity() * (LEVEL * n);
        let step = solved(along + across)
            .filter(|step| step.norm() <= self.radius)
            .or_else(|| solved(along + positive + level));
        step.map_or(Vec3::zero(), |s| Vec3::new(s.x, s.y, s.z))
    }
}
