//! How the energies of a problem are weighed and how it is solved: the choices of scene files.

use crate::sparse::Factorization;
use serde::{Deserialize, Serialize};

/// `lambda_shape`, `lambda_close`, `lambda_smooth` of Eq. 13.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Weights {
    /// Of `E_shape`, Eq. 4.
    pub shape: f64,
    /// Of `E_close`, Eq. 11.
    pub close: f64,
    /// Of `E_smooth`, Eq. 12.
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

/// The least part of their length that edges keep by default: without a bound, coincident vertices would
/// meet most constraints.
pub const SHORTEST_EDGE: f64 = 0.3;

/// How a scene is solved.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SolverSettings {
    /// Iterations at most.
    pub iterations: u32,
    /// Relative change of the total energy per iteration below which it stops; 0 never stops early.
    pub tolerance: f64,
    /// How steps are accelerated.
    pub accelerator: Accelerator,
    /// How many previous steps the accelerator remembers; 0 is the plain iteration.
    pub window: u32,
    /// Whether `N_i` of Eq. 5 is used; without, it is the identity (Fig. 10).
    pub mean_centring: bool,
    /// Keep the nearer of the new and the previous projection, so that the total never rises with
    /// operators that are not exact either.
    pub monotone: bool,
    /// Which numeric phase factors the normal matrix.
    pub factorization: Factorization,
    /// While hard constraints are met, edges of their faces keep this part of their length at rest, at most one;
    /// none is no guard.
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

/// How steps are accelerated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accelerator {
    /// Not at all: the paper's plain iteration.
    None,
    /// L-BFGS whose initial metric is the factored normal matrix.
    QuasiNewton,
    /// Anderson acceleration.
    Anderson,
}

/// `c(v)`: what a vertex is kept close to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClosenessTo {
    /// The closest point on the rest surface; without faces on its curves, and without these among its points.
    #[default]
    Surface,
    /// The vertex's own rest position.
    Rest,
    /// Nothing.
    None,
    /// The closest point on another surface.
    Target,
}

/// Boundary vertices stay on the rest shape of their own boundary loop, or close to its closest point, and corners at
/// their rest positions. A corner that is a handle is held by that instead, and is kept close to its rest position.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BoundaryCloseness {
    /// A vertex is a corner where the boundary turns by more than this, in degrees from 0 to 180.
    pub corners: f64,
    /// Whether vertices are on the curve or close to it.
    pub require: BoundaryRequire,
    /// Where that is soft: a factor of `k_v` for boundary vertices, not negative.
    pub weight: f64,
}

impl Default for BoundaryCloseness {
    fn default() -> Self {
        BoundaryCloseness { corners: 45.0, require: BoundaryRequire::Soft, weight: 1.0 }
    }
}

/// The requirement on boundary vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundaryRequire {
    /// They are kept close to their curve, weighed against all else.
    #[default]
    Soft,
    /// They glide on their curve and nowhere else; corners are fixed. A soft handle pulls them along it, and corners
    /// not at all; a fixed handle has its vertex where it says.
    Exact,
}
