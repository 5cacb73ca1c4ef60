//! Brute force: the least squared distance of points to a shape with free parameters, by
//! Levenberg-Marquardt with numerical derivatives from many random starts.

use crate::support::random::{Random, size};
use crate::support::shapes::{Closest, Vertex};
use nalgebra::{DMatrix, DVector};
use shape_up::math::Vec3;

/// Least sum of squared distances found by `starts` searches. `closest` returns the point of the
/// shape with the given parameters that is closest to a vertex.
pub(crate) fn least_distance_squared(
    points: &[Vec3<f64>],
    rest: &[Vec3<f64>],
    parameters: usize,
    closest: Closest,
    starts: u64,
) -> f64 {
    let residual = |p: &DVector<f64>| {
        DVector::from_iterator(
            3 * points.len(),
            points.iter().zip(rest).enumerate().flat_map(|(index, (v, rest))| {
                let vertex = Vertex { index, of: points.len(), rest: *rest };
                <[f64; 3]>::from(*v - closest(p.as_slice(), *v, vertex))
            }),
        )
    };
    let mut random = Random::new(starts);
    let extent = size(points);
    (0..starts)
        .map(|_| {
            let start = DVector::from_fn(parameters, |_, _| 1.5 * extent * random.uniform());
            descend(start, extent, &residual)
        })
        .filter(|energy| energy.is_finite())
        .fold(f64::INFINITY, f64::min)
}

/// Energy at the local minimum reached from `p`.
fn descend(
    mut p: DVector<f64>,
    extent: f64,
    residual: &impl Fn(&DVector<f64>) -> DVector<f64>,
) -> f64 {
    let mut r = residual(&p);
    let mut damping = 1e-2;
    for _ in 0..400 {
        let mut jacobian = DMatrix::zeros(r.len(), p.len());
        for j in 0..p.len() {
            let step = 1e-6 * extent.max(p[j].abs());
            let (mut above, mut below) = (p.clone(), p.clone());
            above[j] += step;
            below[j] -= step;
            jacobian.set_column(j, &((residual(&above) - residual(&below)) / (2.0 * step)));
        }
        let gradient = jacobian.tr_mul(&r);
        let normal = jacobian.tr_mul(&jacobian);
        let mut accepted = false;
        while damping < 1e12 {
            let mut damped = normal.clone();
            for j in 0..p.len() {
                damped[(j, j)] += damping * (normal[(j, j)] + 1e-12 * normal.trace());
            }
            let Some(step) = damped.cholesky().map(|c| c.solve(&gradient)) else {
                damping *= 10.0;
                continue;
            };
            let candidate = &p - &step;
            let r_candidate = residual(&candidate);
            if r_candidate.norm_squared() < r.norm_squared() {
                accepted = r.norm_squared() - r_candidate.norm_squared() > 1e-14 * r.norm_squared();
                (p, r) = (candidate, r_candidate);
                damping = (damping * 0.1).max(1e-12);
                break;
            }
            damping *= 10.0;
        }
        if !accepted {
            break;
        }
    }
    r.norm_squared()
}
