//! Node axes: the exact ones where there are any, else those of the least-squares fit.
//!
//! With `P_e x = x - (x . t_e) t_e`, what is minimised is
//!
//! ```text
//! E(n) = sum_e |P_e (n_j - n_i)|^2 + D(n) + mu sum_i |n_i - N_i|^2
//! corner  D = sum_i (|n_i| - 1)^2
//! face    D = sum over corners (i, f) of (N_f . n_i - 1)^2
//! edge    D = sum over edges, both ends, of (|P_e n_i| - 1)^2
//! ```
//!
//! by Newton steps from `n = N`. With `u` the direction of `x` in the last step, `(|x| - 1)^2` has the Hessian
//! `u u' + c (I - u u')`, `c = 1 - 1 / |x|`; the second part takes `x` itself to zero, so that it changes the
//! matrix of Gauss-Newton, where `|x| - 1` is `u . x - 1`, and not its right-hand side. Where `c < 0` makes the
//! matrix indefinite, it is left out: Gauss-Newton takes some steps more. All terms are without unit; `mu` trades
//! flat beams for upright axes. Only long steps factor their matrix: the others are solved by conjugate gradients
//! with the last factor.
//!
//! The exact pass is `mu -> 0` without a choice of `mu`: proximal steps, ten times with one factor (corner and
//! face). For corners it minimises `sum_e |n_j - R_e n_i|^2` with the reflections `R_e = I - 2 t_e t_e'`
//! among unit vectors: its matrix is a connection Laplacian, and where circles close all around its zero modes
//! are the exact axes. Carrying an axis from vertex to vertex by `R_e` instead would twist the last beams by
//! degrees on a mesh whose circles are off by a thousandth.

use super::check::{most_lean, within};
use super::exact::{can_be_exact, exact_pass};
use super::kind::OffsetKind;
use super::newton::{Start, Until, descend};
use super::system::System;
use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;

/// An exact axis leans at most so many degrees more than the most leaning of the fit.
const MOST_LEAN: f64 = 30.0;

/// The axes of an offset.
#[derive(Clone, Debug)]
pub struct Axes {
    /// `#V` node axes; zero at vertices of no panel.
    pub axes: Vec<Vec3<f64>>,
    /// The elements that keep their distance.
    pub kind: OffsetKind,
    /// Whether they come from the exact pass.
    pub exact: bool,
}

/// Of each kind the exact axes where beam warp and distance error at the distance `depth` stay below `tolerance`
/// and no axis leans much more than the fit's; else the fit.
pub(in crate::fabricate) fn axes_of(
    surface: &PanelSurface,
    kinds: &[OffsetKind],
    mu: f64,
    depth: f64,
    tolerance: f64,
) -> Vec<Axes> {
    let system = &mut System::new(surface);
    let of = |&kind: &OffsetKind| {
        let normals = surface.normals.clone();
        let fitted = descend(system, surface, kind, mu, Start::At(normals), Until::Still);
        let exact = can_be_exact(surface, kind, depth, tolerance)
            .then(|| exact_pass(system, surface, kind, (mu, fitted.clone())))
            .filter(|exact| {
                within(surface, exact, kind, depth, tolerance)
                    && most_lean(surface, exact) <= most_lean(surface, &fitted) + MOST_LEAN
            });
        Axes { exact: exact.is_some(), axes: exact.unwrap_or(fitted), kind }
    };
    kinds.iter().map(of).collect()
}

/// The least-squares axes with the weight `mu` of following the surface.
pub fn fit(surface: &PanelSurface, kind: OffsetKind, mu: f64) -> Vec<Vec3<f64>> {
    descend(
        &mut System::new(surface),
        surface,
        kind,
        mu,
        Start::At(surface.normals.clone()),
        Until::Still,
    )
}

/// The axes of the exact pass: what it leaves on a mesh without exact axes is of no use.
pub fn exact(surface: &PanelSurface, kind: OffsetKind) -> Vec<Vec3<f64>> {
    let system = &mut System::new(surface);
    let fitted = match kind {
        OffsetKind::Edge => {
            descend(system, surface, kind, 1.0, Start::At(surface.normals.clone()), Until::Still)
        }
        _ => surface.normals.clone(),
    };
    exact_pass(system, surface, kind, (1.0, fitted))
}
