//! The weights of the energies and the settings of the solver, as in scene files.

use crate::sparse::Factorization;
use serde::{Deserialize, Serialize};

/// `lambda_shape`, `lambda_close`, `lambda_smooth` of Eq. 13.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Weights {
    /// Weight of `E_shape`, Eq. 4.
    pub shape: f64,
    /// Weight of `E_close`, Eq. 11.
    pub close: f64,
    /// Weight of `E_smooth`, Eq. 12.
    pub smooth: f64,
}

impl Default for Weights {
    fn default() -> Self {
        Weights { shape: 1.0, close: 0.0, smooth: 0.0 }
    }
}

/// The quantity `l` and the weights `w` of the smoothness energy (Eq. 12).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Smoothness {
    /// `l_i` of Eq. 12.
    pub of: SmoothnessOf,
    /// `w_ij` of Eq. 12.
    pub weighting: Weighting,
}

/// `l_i` of Eq. 12.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum SmoothnessOf {
    /// The positions: `l = v`.
    #[default]
    Surface,
    /// The displacements: `l = v - v'`.
    Displacement,
}

/// `w_ij` of Eq. 12.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weighting {
    /// Cotangent on pure triangle meshes, else uniform.
    #[default]
    Auto,
    /// `w_ij = 1`.
    Uniform,
    /// `w_ij = (cot a + cot b) / 2` on the rest mesh; triangle meshes only.
    Cotangent,
    /// The same for polygons with any number of corners, planar or not (Alexa, Wardetzky 2011).
    Polygon,
}

/// The least length of edges, relative to rest, by default. Without a bound, coincident vertices
/// would meet most constraints.
pub const SHORTEST_EDGE: f64 = 0.3;

/// The settings of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SolverSettings {
    /// Greatest number of iterations.
    pub iterations: u32,
    /// Relative change of the total energy per iteration below which the run stops; 0 never stops
    /// early.
    pub tolerance: f64,
    /// The acceleration of steps.
    pub accelerator: Accelerator,
    /// Number of previous steps that the accelerator uses; 0 is the plain iteration.
    pub window: u32,
    /// Whether `N_i` of Eq. 5 is used; otherwise it is the identity (Fig. 10).
    pub mean_centring: bool,
    /// Keeps the nearer of the new and the previous projection, so that the total energy never
    /// rises, even with approximate operators.
    pub monotone: bool,
    /// The numeric factorisation of the normal matrix.
    pub factorization: Factorization,
    /// Least length of the edges of faces with hard constraints, relative to rest, at most one.
    /// `None` is no guard.
    pub shortest_edge: Option<f64>,
}

impl Default for SolverSettings {
    fn default() -> Self {
        SolverSettings {
            iterations: 200,
            tolerance: 1e-9,
            accelerator: Accelerator::QuasiNewton,
            window: 5,
            mean_centring: true,
            monotone: false,
            factorization: Factorization::default(),
            shortest_edge: Some(SHORTEST_EDGE),
        }
    }
}

/// The acceleration of steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accelerator {
    /// None: the paper's plain iteration.
    None,
    /// L-BFGS whose initial metric is the factored normal matrix.
    QuasiNewton,
    /// Anderson acceleration.
    Anderson,
}

/// `c(v)`: the point that a vertex is kept close to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum ClosenessTo {
    /// The closest point of the rest surface; of the curves if there are no faces, of the points if
    /// there are no curves either. Beside faces, a vertex of none has its rest position, as for
    /// [`ClosenessTo::Target`].
    #[default]
    Surface,
    /// The vertex's own rest position.
    Rest,
    /// Nothing.
    None,
    /// The closest point on another surface.
    Target,
}

/// Boundary vertices stay on the rest curve of their own boundary loop, or close to its closest
/// point, and corners at their rest positions. A corner with a handle is held by the handle
/// instead, and kept close to its rest position.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BoundaryCloseness {
    /// A vertex is a corner if the boundary turns there by more than this, in degrees from 0 to
    /// 180.
    pub corners: f64,
    /// Whether vertices stay on the curve, or close to it, or neither.
    #[serde(default = "soft", skip_serializing_if = "is_soft")]
    pub require: BoundaryRequire,
    /// With a soft requirement, a factor of `k_v` for boundary vertices, not negative.
    #[serde(skip_serializing_if = "is_one")]
    pub weight: f64,
}

impl BoundaryCloseness {
    /// Returns it without numbers that have no effect: corners count where the boundary is held, and the
    /// weight where it is held softly.
    pub(crate) fn in_effect(self) -> BoundaryCloseness {
        let free = BoundaryCloseness::default();
        match self.require {
            BoundaryRequire::Off => free,
            BoundaryRequire::Soft => self,
            BoundaryRequire::Exact => BoundaryCloseness { weight: free.weight, ..self },
        }
    }
}

/// What scene files mean that say where the corners are, and not how the boundary is held.
fn soft() -> BoundaryRequire {
    BoundaryRequire::Soft
}

fn is_soft(require: &BoundaryRequire) -> bool {
    *require == soft()
}

fn is_one(weight: &f64) -> bool {
    *weight == 1.0
}

impl Default for BoundaryCloseness {
    fn default() -> Self {
        BoundaryCloseness { corners: 45.0, require: BoundaryRequire::Off, weight: 1.0 }
    }
}

/// The requirement on boundary vertices, in order of strength.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BoundaryRequire {
    /// None: they are vertices like all others.
    Off,
    /// They are kept close to their curve, weighed against all other energies.
    Soft,
    /// They glide on their curve only; corners are fixed. A soft handle pulls a vertex along its
    /// curve, and has no effect on a corner. A fixed handle puts its vertex at the target.
    Exact,
}
