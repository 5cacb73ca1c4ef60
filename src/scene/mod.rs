//! The scene: a mesh, what its parts shall be, and how it is solved.
//!
//! | file or folder | holds |
//! |---|---|
//! | `document` | the scene as a value: mesh, constraints, handles, settings |
//! | `closeness` | what vertices are kept close to, and how much |
//! | `lesson` | exercises: a text and goals |
//! | `presentation` | the steps in which a scene is shown |
//! | `results` | what a student hands in |
//! | `error` | what is wrong with a scene, with its JSON path |
//! | `json` | the scene file, version 1, in and out |
//! | `validate` | the checks that need the mesh |
//! | `words` | the words for choices, in files and everywhere else |
//! | `units` | the units of length |
//! | `frame` | the unit and the vertical axis of a mesh file, stated or guessed |
//! | `up_guess` | which axis of a mesh likely points up |
//! | `opened` | the settings of a mesh file that somebody opens |
//! | `panels` | the same shape for all panels, by one press, and how far that will move the mesh |
//! | `presets` | settings that belong together |
//! | `problem` | the problem that the solver is given |

mod closeness;
mod document;
mod error;
mod frame;
mod json;
mod lesson;
mod opened;
mod panels;
mod presentation;
mod presets;
mod problem;
mod results;
mod units;
mod up_guess;
mod validate;
mod words;

pub use crate::solve::{
    Accelerator, BoundaryCloseness, BoundaryRequire, ClosenessTo, Hold, Require, Smoothness,
    SmoothnessOf, SolverSettings, Weighting, Weights,
};
pub use crate::sparse::Factorization;
pub use closeness::{Closeness, ClosenessWeight, Target};
pub use document::{
    ConstraintSpec, EasedFaces, HANDLE_WEIGHT, HandleSpec, MeshSource, Pose, Scene, Up, Variant,
    Variants,
};
pub use error::SceneError;
pub use frame::UnitsAndUp;
pub use json::{FORMAT, VERSION};
pub use lesson::{Goal, GoalOf, Lesson, Lock};
pub use panels::{Forecast, ForecastOfKind, HowFar, PanelOffer, panel_offers};
pub use presentation::Slide;
pub use presets::{PRESETS, Preset, PresetOffer};
pub use results::{GoalResult, Results};
pub use units::{LengthUnit, UNITS};
pub use words::NamedEnum;
