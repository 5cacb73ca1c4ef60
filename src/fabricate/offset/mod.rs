//! Offsets: a node axis `n_i` for every vertex, such that the mesh `v_i + d n_i` has parallel edges and keeps
//! its distance. It is then a parallel mesh (Combescure transform), and every strip
//! `v_i, v_j, v_j + d n_j, v_i + d n_i` is a flat beam for every `d`.
//!
//! Sources: Liu, Pottmann, Wallner, Yang, Wang, *Geometric modeling with conical meshes and developable
//! surfaces* (2006); Pottmann, Liu, Wallner, Bobenko, Wang, *Geometry of multi-layer freeform structures for
//! architecture* (2007), which has the three kinds of offsets.
//!
//! Node axes: exact ones if there are any, else a least-squares fit.
//!
//! With `P_e x = x - (x . t_e) t_e`, the fit minimises
//!
//! ```text
//! E(n) = sum_e |P_e (n_j - n_i)|^2 + D(n) + mu sum_i |n_i - N_i|^2
//! corner  D = sum_i (|n_i| - 1)^2
//! face    D = sum over corners (i, f) of (N_f . n_i - 1)^2
//! edge    D = sum over edges with a length, both ends, of (|P_e n_i| - 1)^2
//! ```
//!
//! by Newton steps from `n = N`. With `u` the direction of `x` in the previous step, `(|x| - 1)^2`
//! has the Hessian `u u' + c (I - u u')`, `c = 1 - 1 / |x|`. The second term maps `x` itself to
//! zero, so it changes the Gauss-Newton matrix (of `u . x - 1`), but not its right-hand side. If
//! `c < 0` makes the matrix indefinite, the term is dropped, and Gauss-Newton takes some more
//! steps. All terms are dimensionless; `mu` trades flat beams for upright axes. The matrix is
//! factored for long steps only: short steps are solved by conjugate gradients with the last
//! factor.
//!
//! The exact pass is the limit `mu -> 0` without a choice of `mu`: ten proximal steps with one
//! factor (corner and face). For corners it minimises `sum_e |n_j - R_e n_i|^2` with the
//! reflections `R_e = I - 2 t_e t_e'` over unit vectors. Its matrix is a connection Laplacian; if
//! the reflections close around all loops, its null vectors are the exact axes. Propagating an axis
//! from vertex to vertex by `R_e` instead would twist the last beams by degrees on a mesh whose
//! circles are off by a thousandth.

mod check;
mod closing;
mod exact;
mod newton;
mod reason;
mod system;

pub use check::{BeamCheck, Inexact, NodeCheck, OffsetCheck, check};
pub use closing::{Closing, Closings, closings};
pub(super) use reason::Reason;
pub(super) use system::across_edge;

use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;
use crate::scene::OffsetKind;
use check::{errors, most_lean};
use exact::{can_be_exact, exact_pass};
use newton::{Stage, descend};
use serde::Serialize;
use system::System;

/// Largest additional lean of the exact axes over the largest lean of the fit, in degrees.
const MOST_LEAN: f64 = 30.0;

/// The axes of an offset.
#[derive(Clone, Debug)]
pub struct Axes {
    /// Node axes (`#V`); zero at vertices of no panel.
    pub axes: Vec<Vec3<f64>>,
    /// The elements that keep their distance.
    pub kind: OffsetKind,
    /// Why the exact axes are not taken, but the fit; empty if they are.
    pub inexact: Vec<Inexact>,
}

/// For each kind the exact axes, if beam warp and distance error at the distance `depth` stay below
/// `tolerance` and no axis leans much more than in the fit; else the fit, in which `mu` is the weight of
/// following the surface. Lengths are in the unit of the mesh.
pub fn axes_of(
    surface: &PanelSurface,
    kinds: &[OffsetKind],
    mu: f64,
    depth: f64,
    tolerance: f64,
) -> Vec<Axes> {
    let system = &mut System::new(surface);
    let of = |&kind: &OffsetKind| {
        let fitted = fitted(system, surface, kind, mu);
        if !can_be_exact(surface, kind, depth, tolerance) {
            return Axes { axes: fitted, kind, inexact: vec![Inexact::NoPoint] };
        }
        let exact = exact_pass(system, surface, kind, (mu, fitted.clone()));
        let mut inexact = errors(surface, &exact, kind, depth, tolerance);
        if inexact.is_empty()
            && most_lean(surface, &exact) > most_lean(surface, &fitted) + MOST_LEAN
        {
            inexact.push(Inexact::Lean);
        }
        Axes { axes: if inexact.is_empty() { exact } else { fitted }, kind, inexact }
    };
    kinds.iter().map(of).collect()
}

/// The least-squares axes; `mu` is the weight of following the surface.
fn fitted(
    system: &mut System,
    surface: &PanelSurface,
    kind: OffsetKind,
    mu: f64,
) -> Vec<Vec3<f64>> {
    descend(system, surface, kind, mu, surface.normals.clone(), Stage::Fit)
}

/// The errors that one kind of offset would have, to choose between kinds.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Choice {
    /// The kind.
    pub kind: OffsetKind,
    /// Whether it is exact.
    pub exact: bool,
    /// The beam warp in mm of the building.
    pub warp_mm: f64,
    /// The distance error in mm of the building.
    pub distance_error_mm: f64,
}
