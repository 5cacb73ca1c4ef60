//! The scene: a mesh, what its parts shall be, and how it is solved.
//!
//! | file | holds |
//! |---|---|
//! | `json` | the serde form of the scene file, version 1, in and out |
//! | `lesson` | exercises: a text, goals, and the results that are handed in |
//! | `validate` | the checks that need the mesh |
//! | `closeness` | what vertices are kept close to, and how much |
//! | `words` | the words for choices, in files and everywhere else |
//! | `frame` | the unit and the vertical axis of a mesh file, stated or guessed |
//! | `up_guess` | which axis of a mesh likely points up |
//! | `opened` | the settings of a mesh file that somebody opens |
//! | `panels` | the same shape for all panels, by one press |
//! | `presets` | settings that belong together |

mod closeness;
mod frame;
mod json;
mod lesson;
mod opened;
mod panels;
mod presets;
mod up_guess;
mod validate;
mod words;

pub use closeness::{BoundaryCloseness, Closeness, ClosenessTo, ClosenessWeight};
pub use frame::Frame;
pub(crate) use json::{At, Node, parse, read_constraint, read_indices, read_lesson, read_selector};
pub use json::{FORMAT, VERSION};
pub use lesson::{Goal, GoalOf, GoalResult, Lesson, Results};
pub use panels::{PanelOffer, panel_offers};
pub use presets::{PRESETS, Preset, PresetOffer};
pub use words::Worded;

use crate::constraint::{Kind, Selector, Sets};
use crate::mesh::{Mesh, Point};
use std::fmt;

/// A scene file, checked for form. Whether its indices and names fit the mesh is checked when a
/// session opens it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Shown as the name of the model.
    pub title: String,
    /// Unit of length, such as `"m"`; empty when not known.
    pub units: String,
    /// Which axis points up.
    pub up: Up,
    /// The rest shape.
    pub mesh: MeshSource,
    /// Where the iteration starts, `#V by 3`; at rest when absent.
    pub current: Option<Vec<Point>>,
    /// Named sets.
    pub sets: Sets,
    /// One entry of the list of constraints: a kind on a selector.
    pub constraints: Vec<ConstraintSpec>,
    /// Handles.
    pub handles: Vec<HandleSpec>,
    /// The weights of Eq. 13.
    pub weights: Weights,
    /// What vertices are kept close to, Eq. 11.
    pub closeness: Closeness,
    /// What is smoothed, Eq. 12.
    pub smoothness: Smoothness,
    /// How it is solved.
    pub solver: SolverSettings,
    /// The exercise that it is.
    pub lesson: Option<Lesson>,
}

impl Scene {
    /// A scene without constraints and with the default settings.
    pub fn new(mesh: MeshSource) -> Scene {
        Scene {
            title: String::new(),
            units: String::new(),
            up: Up::Z,
            mesh,
            current: None,
            sets: Sets::new(),
            constraints: Vec::new(),
            handles: Vec::new(),
            weights: Weights::default(),
            closeness: Closeness::default(),
            smoothness: Smoothness::default(),
            solver: SolverSettings::default(),
            lesson: None,
        }
    }
}

/// Which axis points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// y, as in most viewers.
    Y,
    /// z, as in Rhino.
    Z,
}

/// Where the mesh of a scene comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshSource {
    /// A file beside the scene: path relative to it.
    File(String),
    /// In the scene itself.
    Inline(Box<Mesh>),
}

/// A kind of constraint on a selector.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintSpec {
    /// The operator with its parameters.
    pub kind: Kind,
    /// Which vertices.
    pub on: Selector,
    /// `w_i` of Eq. 4, not negative.
    pub weight: f64,
    /// Whether it counts; a disabled one stays in the list.
    pub enabled: bool,
    /// What somebody called it; empty for the label of its kind.
    pub name: String,
}

impl ConstraintSpec {
    /// Its name, or the label of its kind where it has none.
    pub fn label(&self) -> &str {
        if self.name.is_empty() { self.kind.info().label } else { &self.name }
    }
}

/// Vertices held at targets.
#[derive(Clone, Debug, PartialEq)]
pub struct HandleSpec {
    /// Indices of vertices.
    pub vertices: Vec<u32>,
    /// `#vertices by 3`; the rest positions when absent.
    pub targets: Option<Vec<Point>>,
    /// How the targets are met.
    pub hold: Hold,
}

/// How a handle holds its vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// Adds `weight * |v - target|^2` to the total.
    Soft {
        /// Positive.
        weight: f64,
    },
    /// Takes the vertices out of the unknowns: the targets are met exactly.
    Fixed,
}

/// The weight of a soft handle that does not say its own.
pub const HANDLE_WEIGHT: f64 = 100.0;

/// `lambda_shape`, `lambda_close`, `lambda_smooth` of Eq. 13.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// What is smoothed, and with which weights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

/// How a scene is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// What factors the normal matrix.
    pub factorization: Factorization,
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

/// What factors the normal matrix. Both give the same shapes to rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Factorization {
    /// Dense blocks of columns with the same rows, one after another.
    #[default]
    Supernodal,
    /// One column after another, with the crate of that name: the reference.
    SprsLdl,
}

/// What is wrong with a scene, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    /// JSON path, such as `constraints[2].on.set`; empty for the whole file.
    pub path: String,
    /// What is wrong and what was expected.
    pub message: String,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            f.write_str(&self.message)
        } else {
            write!(f, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for SceneError {}
