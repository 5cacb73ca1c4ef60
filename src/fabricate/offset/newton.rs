//! Newton's method for the least-squares axes.

use super::system::{System, across_edge, identity_and_outer, outer};
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::Vec3;
use crate::scene::OffsetKind;

/// Largest number of steps; corners take about 5, edges 10, several times as many without second
/// derivatives.
const MOST_STEPS: usize = 300;
/// The fit ends when no axis moves by more than this in a step: with second derivatives (quadratic
/// convergence), and without.
const STILL: [f64; 2] = [1e-7, 1e-12];
/// If no axis moved by more than this in the last step, the matrix has hardly changed: conjugate
/// gradients with the existing factor are faster than a new factor.
const NEAR: f64 = 0.3;
/// Smallest and largest relative error of conjugate gradients. In between it is the length of the
/// last step, so that convergence stays quadratic.
const ACCURACY: [f64; 2] = [1e-4, 0.03];
/// While the axes are only an intermediate result, stop when a step lowers the energy by less than
/// this fraction.
const WORTH: f64 = 0.1;

/// Which minimum is sought.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    /// The least-squares fit, until the axes do not move.
    Fit,
    /// From a minimum of another `mu`, whose matrix was factored last, until the energy hardly falls.
    Intermediate,
    /// From there, until the axes do not move.
    Last,
}

/// Minimises the energy from these `axes` by Newton's method; a step that would raise the energy is
/// halved.
pub(super) fn descend(
    system: &mut System,
    surface: &PanelSurface,
    kind: OffsetKind,
    mu: f64,
    mut axes: Vec<Vec3<f64>>,
    stage: Stage,
) -> Vec<Vec3<f64>> {
    // Whether the matrix is close to the one factored last.
    let mut is_near = stage != Stage::Fit;
    let mut lowest = energy(surface, kind, mu, &axes);
    let mut last = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let accuracy = last.clamp(ACCURACY[0], ACCURACY[1]);
        let near = is_near.then(|| {
            assemble(system, surface, kind, mu, &axes, true);
            system.solve_near(&axes, accuracy)
        });
        let (aim, curved, error) = match near.flatten() {
            Some(aim) => (aim, true, accuracy),
            None => {
                let factored = [true, false].into_iter().find(|&curved| {
                    assemble(system, surface, kind, mu, &axes, curved);
                    system.factor()
                });
                let Some(curved) = factored else { break };
                (system.solve(), curved, 0.0)
            }
        };
        let mut share = 1.0;
        let (next, value) = loop {
            let towards = |(from, to): (&Vec3<f64>, &Vec3<f64>)| *from + (*to - *from) * share;
            let next: Vec<_> = axes.iter().zip(&aim).map(towards).collect();
            let value = energy(surface, kind, mu, &next);
            if value <= lowest * (1.0 + 1e-14) || share < 1e-4 {
                break (next, value);
            }
            share *= 0.5;
        };
        if value > lowest * (1.0 + 1e-14) || value.is_nan() {
            break;
        }
        let length = axes.iter().zip(&next).map(|(from, to)| (*to - *from).length());
        let length = length.fold(0.0, f64::max);
        let is_settled = value > lowest * (1.0 - WORTH);
        // Expected length of the next step: quadratic convergence, plus the error of conjugate
        // gradients.
        let next_length = length * (length / last * (length / last) + error);
        let is_still = match curved && share == 1.0 {
            true => length <= STILL[0] || (last.is_finite() && next_length <= STILL[0]),
            false => length <= STILL[1],
        };
        (axes, lowest, last) = (next, value.min(lowest), length);
        is_near = length < NEAR;
        if is_still || kind == OffsetKind::Face || (stage == Stage::Intermediate && is_settled) {
            break;
        }
    }
    axes
}

/// Assembles the system of one step; without `curved` the Gauss-Newton system.
fn assemble(
    system: &mut System,
    surface: &PanelSurface,
    kind: OffsetKind,
    mu: f64,
    axes: &[Vec3<f64>],
    curved: bool,
) {
    // The factor `c` for a vector of this length.
    let across_axis = |length: f64| if curved && length > 0.0 { 1.0 - 1.0 / length } else { 0.0 };
    system.reset_with_beams(mu, &surface.normals);
    if kind == OffsetKind::Edge {
        for (edge, t) in surface.beams() {
            for v in edge.ends {
                let p = across_edge(axes[v as usize], t);
                let (u, c) = (unit(p), across_axis(p.length()));
                system.add(v, identity_and_outer(c, 1.0 - c, u));
                system.add(v, identity_and_outer(0.0, -c, t));
                system.add_rhs(v, u);
            }
        }
    }
    match kind {
        OffsetKind::Corner => {
            for v in 0..axes.len() {
                if surface.normals[v] != Vec3::zero() {
                    let (u, c) = (unit(axes[v]), across_axis(axes[v].length()));
                    system.add(v as u32, identity_and_outer(c, 1.0 - c, u));
                    system.add_rhs(v as u32, u);
                }
            }
        }
        OffsetKind::Face => {
            for (v, pull) in add_faces(system, surface) {
                system.add_rhs(v, pull);
            }
        }
        OffsetKind::Edge => {}
    }
}

/// The energy `E(n)`.
pub(super) fn energy(surface: &PanelSurface, kind: OffsetKind, mu: f64, axes: &[Vec3<f64>]) -> f64 {
    let mut sum = 0.0;
    let square = |x: f64| x * x;
    for edge in surface.real_edges() {
        let t = surface.direction(edge);
        let [n, m] = edge.ends.map(|v| axes[v as usize]);
        sum += across_edge(m - n, t).length_squared();
        if kind == OffsetKind::Edge && t != Vec3::zero() {
            sum += square(across_edge(n, t).length() - 1.0);
            sum += square(across_edge(m, t).length() - 1.0);
        }
    }
    for (axis, normal) in axes.iter().zip(&surface.normals) {
        sum += mu * (*axis - *normal).length_squared();
        if kind == OffsetKind::Corner && *normal != Vec3::zero() {
            sum += square(axis.length() - 1.0);
        }
    }
    if kind == OffsetKind::Face {
        for (face, f) in surface.faces.iter().zip(0..) {
            let normal = surface.normal(f);
            sum += face.iter().map(|&v| square(normal.dot(axes[v as usize]) - 1.0)).sum::<f64>();
        }
    }
    sum
}

/// Adds the term `D` of faces, and returns its contributions to the right-hand side.
pub(super) fn add_faces(system: &mut System, surface: &PanelSurface) -> Vec<(u32, Vec3<f64>)> {
    let mut pulls = Vec::new();
    for (face, f) in surface.faces.iter().zip(0..) {
        let normal = surface.normal(f);
        for &v in face {
            system.add(v, outer(normal));
            pulls.push((v, normal));
        }
    }
    pulls
}
