//! The scene: a mesh, its constraints, and the solver settings.
//!
//! | file or folder | holds |
//! |---|---|
//! | `document` | data types: mesh, constraints, handles, settings |
//! | `closeness` | target and factors of the closeness energy |
//! | `lesson` | lessons: a task and goals |
//! | `presentation` | the steps of a presentation |
//! | `results` | the results that a student hands in |
//! | `error` | errors with their JSON path |
//! | `json` | reading and writing the scene file, version 1 |
//! | `validate` | checks of numbers, and of indices and names against the mesh |
//! | `words` | the words of enumerations, in files and everywhere else |
//! | `units` | the units of length |
//! | `frame` | unit and up axis of a mesh file, stated or guessed |
//! | `up_guess` | guess of the axis that points up |
//! | `opened` | the settings of a mesh file that the user opens |
//! | `panels` | one shape for all panels, and a forecast of how far the mesh will move |
//! | `presets` | presets of weights, closeness and smoothness |
//! | `problem` | the problem passed to the solver |

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
pub(crate) use panels::all_faces;
pub use panels::{
    Forecast, ForecastOfKind, HowFar, MeshRemedy, PanelOffer, panel_offers, panel_remedy,
};
pub use presentation::Slide;
pub use presets::{PRESETS, Preset, PresetOffer};
pub use results::{GoalResult, Results};
pub use units::{LengthUnit, UNITS};
pub use words::NamedEnum;
