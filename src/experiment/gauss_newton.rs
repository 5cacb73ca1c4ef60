//! Gauss-Newton on a penalty function, as in Liu et al. 2006: the squared residuals of
//! `AngleSums`, with the fairness and closeness of Eq. 13.
//!
//! Their criterion for a quad with a circumscribed circle needs no fit (Liu, Pottmann, Wallner,
//! Yang, Wang: Geometric modeling with conical meshes and developable surfaces, 2006): the sums of
//! opposite angles are pi, and the corners are coplanar. The residuals are dimensionless.

use crate::constraint::Row;
use crate::math::{Vec3, angle, polygon_sides};
use crate::mesh::{Laplacian, Point};
use crate::solve::{System, Terms};
use std::f64::consts::PI;

/// Number of residuals of a quad.
const RESIDUALS: usize = 3;

/// The residuals of one quad with their derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
struct AngleSums {
    /// The sum of the first and the third angle minus pi, the same for the second and the fourth,
    /// and the signed volume spanned by the corners. The angle sums alone are insensitive to a
    /// small bend: they change with its square.
    residuals: [f64; 3],
    /// Derivative of each residual by each corner.
    derivatives: [[Vec3<f64>; 4]; 3],
}

impl AngleSums {
    /// Evaluates the residuals at four corners, in order around the quad. The volume is divided by
    /// `length` cubed. The result is not finite if an edge has zero length or two adjacent edges
    /// are collinear: the angles then have no derivative.
    fn of(corners: [Vec3<f64>; 4], length: f64) -> AngleSums {
        let mut residuals = [-PI, -PI, 0.0];
        let mut derivatives = [[Vec3::zero(); 4]; RESIDUALS];
        for k in 0..4 {
            let [next, before] = [(k + 1) % 4, (k + 3) % 4];
            let (u, v) = (corners[next] - corners[k], corners[before] - corners[k]);
            let (u_length, v_length) = (u.length(), v.length());
            let (u, v) = (u * (1.0 / u_length), v * (1.0 / v_length));
            let (cosine, sine) = (u.dot(v), u.cross(v).length());
            let sum = k % 2;
            residuals[sum] += angle(cosine, sine).unwrap_or(f64::NAN);
            let by_next = (u * cosine - v) * (1.0 / (sine * u_length));
            let by_before = (v * cosine - u) * (1.0 / (sine * v_length));
            let by = &mut derivatives[sum];
            by[next] += by_next;
            by[before] += by_before;
            by[k] += by_next * -1.0 - by_before;
        }
        let scale = 1.0 / (length * length * length);
        let [a, b, c] = [1, 2, 3].map(|k| corners[k] - corners[0]);
        residuals[2] = scale * a.dot(b.cross(c));
        let [by_a, by_b, by_c] = [b.cross(c), c.cross(a), a.cross(b)].map(|by| by * scale);
        derivatives[2] = [(by_a + by_b + by_c) * -1.0, by_a, by_b, by_c];
        AngleSums { residuals, derivatives }
    }
}

/// Regularisation of the diagonal, relative to its mean: the normal matrix of Gauss-Newton may be
/// singular.
const DAMPING: f64 = 1e-6;
/// Number of trial steps, each half as long as the one before.
const TRIALS: u32 = 40;

/// Index of the circle terms in the system.
const CIRCLES: usize = 0;

/// A quad mesh whose panels are made circular.
pub(super) struct GaussNewton {
    /// `#V by 3`
    pub(super) positions: Vec<Point>,
    quads: Vec<[u32; 4]>,
    laplacian: Laplacian,
    /// Positions that closeness refers to, `#V by 3`.
    rest: Vec<Point>,
    /// Whether each vertex is fixed, `#V`.
    fixed: Vec<bool>,
    /// Weights of closeness and fairness.
    weights: [f64; 2],
    /// Mean edge length at rest, which converts an angle to a length.
    length: f64,
    /// Linear system over the coordinates of all vertices: x, y and z of each.
    system: System,
}

/// The energies of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Penalties {
    /// The sum of the squared residuals, times the squared length.
    pub(super) circles: f64,
    /// `E_close` to the rest positions.
    pub(super) close: f64,
    /// `E_smooth`.
    pub(super) smooth: f64,
}

impl GaussNewton {
    /// Begins at `start`; `weights` are those of closeness to `rest` and of fairness.
    pub(super) fn new(
        rest: &[Point],
        start: &[Point],
        quads: Vec<[u32; 4]>,
        laplacian: Laplacian,
        fixed: Vec<bool>,
        weights: [f64; 2],
    ) -> GaussNewton {
        let sides = quads.iter().flat_map(|quad| polygon_sides(quad));
        let lengths = sides.map(|[a, b]| (at(rest, b) - at(rest, a)).length());
        let (sum, count) = lengths.fold((0.0, 0.0), |(sum, count), l| (sum + l, count + 1.0));
        let mut circles = Terms::default();
        for quad in &quads {
            let nodes = quad.map(coordinates).concat();
            (0..RESIDUALS).for_each(|_| circles.push(&nodes, [0.0; 12], 0.0, 1.0));
        }
        let mut smooth = Terms::default();
        for (i, (neighbours, weights)) in laplacian.rows().enumerate() {
            let own = -weights.iter().sum::<f64>();
            let nodes: Vec<u32> = [&[i as u32], neighbours].concat();
            for k in 0..3 {
                let nodes: Vec<u32> = nodes.iter().map(|&v| 3 * v + k).collect();
                smooth.push(&nodes, std::iter::once(own).chain(weights.iter().copied()), 0.0, 1.0);
            }
        }
        GaussNewton {
            positions: start.to_vec(),
            quads,
            laplacian,
            fixed,
            weights,
            length: sum / count,
            system: System::new(3 * rest.len(), vec![circles, smooth]),
            rest: rest.to_vec(),
        }
    }

    /// The energies at the current positions.
    pub(super) fn penalties(&self) -> Penalties {
        self.penalties_at(&self.positions)
    }

    fn penalties_at(&self, positions: &[Point]) -> Penalties {
        let mut circles = 0.0;
        for quad in &self.quads {
            let found = AngleSums::of(quad.map(|v| at(positions, v)), self.length);
            circles += found.residuals.iter().map(|r| r * r).sum::<f64>();
        }
        let close = positions.iter().zip(&self.rest);
        let close = close.map(|(&p, &r)| (Vec3::from(p) - Vec3::from(r)).length_squared()).sum();
        let smooth = (0..positions.len()).map(|i| self.laplace(positions, i).length_squared());
        Penalties { circles: self.length * self.length * circles, close, smooth: smooth.sum() }
    }

    /// Returns the objective for a weight of the circles.
    pub(super) fn total(&self, circles: f64, penalties: Penalties) -> f64 {
        let [close, smooth] = self.weights;
        circles * penalties.circles + close * penalties.close + smooth * penalties.smooth
    }

    fn laplace(&self, positions: &[Point], i: usize) -> Vec3<f64> {
        let own = at(positions, i as u32);
        let (neighbours, weights) = self.laplacian.row(i);
        let terms = neighbours.iter().zip(weights).map(|(&j, &w)| (at(positions, j) - own) * w);
        terms.fold(Vec3::zero(), |a, b| a + b)
    }

    /// Returns half the gradient of the total at the current positions, three coordinates per
    /// vertex. Also sets the coefficients of the system to the derivatives of the residuals.
    fn linearise(&mut self, weight: f64) -> Vec<f64> {
        let mut gradient = vec![0.0; 3 * self.positions.len()];
        let mut add = |v: u32, by: Vec3<f64>| {
            let own = &mut gradient[3 * v as usize..][..3];
            own.iter_mut().zip([by.x, by.y, by.z]).for_each(|(own, by)| *own += by);
        };
        let [close, smooth] = self.weights;
        let mut coefficients = Vec::new();
        for quad in &self.quads {
            let found = AngleSums::of(quad.map(|v| at(&self.positions, v)), self.length);
            for (residual, by) in found.residuals.iter().zip(found.derivatives) {
                for (&v, by) in quad.iter().zip(by) {
                    let by = by * self.length;
                    coefficients.extend([by.x, by.y, by.z]);
                    add(v, by * (weight * self.length * residual));
                }
            }
        }
        for i in 0..self.positions.len() {
            let v = i as u32;
            add(v, (at(&self.positions, v) - at(&self.rest, v)) * close);
            let row = self.laplace(&self.positions, i) * smooth;
            let (neighbours, weights) = self.laplacian.row(i);
            for (&j, &w) in neighbours.iter().zip(weights) {
                add(j, row * w);
                add(v, row * -w);
            }
        }
        for (v, _) in (0..).zip(&self.fixed).filter(|(_, fixed)| **fixed) {
            gradient[3 * v..][..3].fill(0.0);
        }
        self.system.set_coefficients(CIRCLES, &coefficients);
        gradient
    }

    /// Takes one step for a weight of the circles, halved until the total decreases. Returns false
    /// if the system cannot be factored, or if no trial step is finite and lowers the total.
    pub(super) fn step(&mut self, weight: f64) -> bool {
        let before = self.total(weight, self.penalties());
        let gradient = self.linearise(weight);
        let n = gradient.len();
        let node_of = self.system.node_of().to_vec();
        let mut fixed = vec![false; n];
        (0..n).for_each(|k| fixed[node_of[k] as usize] = self.fixed[k / 3]);
        let [close, smooth] = self.weights;
        let damping = DAMPING * (weight + smooth + close);
        let factored = self.system.factor(&[weight, smooth], &vec![close + damping; n], fixed);
        if factored.is_err() {
            return false;
        }
        let mut step: Vec<Row> = vec![[0.0; 4]; n];
        (0..n).for_each(|k| step[node_of[k] as usize][0] = gradient[k]);
        self.system.solve(&mut step);
        let displacement = |v: usize, k: usize| step[node_of[3 * v + k] as usize][0];
        let mut part = 1.0;
        for _ in 0..TRIALS {
            let mut next = self.positions.clone();
            for (v, p) in next.iter_mut().enumerate() {
                (0..3).for_each(|k| p[k] -= part * displacement(v, k));
            }
            // Written so that NaN is rejected.
            if self.total(weight, self.penalties_at(&next)) < before {
                self.positions = next;
                return true;
            }
            part *= 0.5;
        }
        false
    }
}

fn at(positions: &[Point], v: u32) -> Vec3<f64> {
    positions[v as usize].into()
}

fn coordinates(v: u32) -> [u32; 3] {
    [3 * v, 3 * v + 1, 3 * v + 2]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudo-random numbers from -1 to 1.
    fn noise(mut seed: u32) -> impl FnMut() -> f64 {
        move || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1 << 23) - 1.0
        }
    }

    fn quad(random: &mut impl FnMut() -> f64) -> [Vec3<f64>; 4] {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.2, 1.0], [-0.1, 0.9]];
        corners.map(|[x, y]| {
            let [a, b, c] = [0; 3].map(|_| 0.1 * random());
            Vec3::new(x + a, y + b, c)
        })
    }

    #[test]
    fn the_derivatives_of_the_angle_sums_are_those_of_their_differences() {
        let mut random = noise(3);
        for _ in 0..50 {
            let corners = quad(&mut random);
            let found = AngleSums::of(corners, 0.7);
            for v in 0..4 {
                for k in 0..3 {
                    const STEP: f64 = 1e-6;
                    let at = |step: f64| {
                        let mut moved = corners;
                        let by = [0, 1, 2].map(|i| if i == k { step } else { 0.0 });
                        moved[v] += Vec3::from(by);
                        AngleSums::of(moved, 0.7).residuals
                    };
                    let (more, less) = (at(STEP), at(-STEP));
                    for r in 0..3 {
                        let difference = (more[r] - less[r]) / (2.0 * STEP);
                        let by = found.derivatives[r][v];
                        let by = [by.x, by.y, by.z][k];
                        assert!((difference - by).abs() < 1e-7, "{r}, {v}, {k}: {difference} {by}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_residuals_vanish_on_circles_only() {
        let mut random = noise(5);
        for _ in 0..50 {
            // Four points around a circle in an inclined plane.
            let (u, v) = (Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, 1.0, 0.0));
            let turns = [0.0, 0.25, 0.5, 0.75].map(|t| t + 0.1 * random());
            let at = |t: f64| u * crate::math::cosine(t) + v * crate::math::sine(t);
            let on = AngleSums::of(turns.map(at), 1.0);
            assert!(on.residuals.iter().all(|r| r.abs() < 1e-12), "{:?}", on.residuals);
            let mut off = turns.map(at);
            off[2] = off[2] * 1.1;
            let off = AngleSums::of(off, 1.0);
            assert!(off.residuals[0].abs() > 1e-2 && off.residuals[2].abs() < 1e-12);
            let mut bent = turns.map(at);
            bent[2] += u.cross(v) * 0.1;
            assert!(AngleSums::of(bent, 1.0).residuals[2].abs() > 1e-3);
        }
    }
}
