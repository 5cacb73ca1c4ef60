//! The scene: a mesh, its constraints, and the solver settings.
//!
//! | file or folder | holds |
//! |---|---|
//! | `build` | the settings of what is built from the shape |
//! | `document` | data types: mesh, constraints, handles, settings; the problem that they pose |
//! | `attempt` | the attempt by which a search met hard constraints, and the settings that it changed |
//! | `closeness` | target and factors of the closeness energy |
//! | `lesson` | lessons: a task and goals |
//! | `presentation` | kept shapes, and the steps of a presentation |
//! | `results` | the results that a student hands in |
//! | `error` | errors with their JSON path |
//! | `json` | reading and writing the scene file, version 1 |
//! | `validate` | checks of numbers, and of indices and names against the mesh |
//! | `words` | the words of enumerations, in files and everywhere else |
//! | `frame` | unit and up axis of a mesh file, stated or guessed |
//! | `up_guess` | guess of the axis that points up |
//! | `panels` | one shape for all panels, and a forecast of how far the mesh will move |
//! | `presets` | presets of weights, closeness and smoothness, also of a mesh file that the user opens |

mod attempt;
mod build;
mod closeness;
mod document;
mod error;
mod frame;
mod json;
mod lesson;
mod panels;
mod presentation;
mod presets;
mod results;
mod up_guess;
mod validate;
mod words;

pub use crate::solve::{
    Accelerator, BoundaryCloseness, BoundaryRequire, ClosenessTo, Hold, Require, Smoothness,
    SmoothnessOf, SolverSettings, Weighting, Weights,
};
pub use crate::sparse::Factorization;
pub(crate) use attempt::AttemptSetting;
pub use build::{
    BUILD_PRESETS, BUILD_SETTINGS, BuildForm, BuildGroup, BuildOption, BuildPreset, BuildSetting,
    BuildSettings, BuildUnit, CheckLimits, Dxf, Fold, Join, Names, OffsetKind, Order, Page, Pieces,
    PresetOf, PresetValues, Product,
};
pub(crate) use build::{Tiling, ordered};
pub use closeness::{Closeness, ClosenessWeight, Target};
pub use document::{
    AttemptStart, ChosenAttempt, ConstraintSpec, EasedFaces, HANDLE_WEIGHT, HandleSpec, MeshSource,
    Pose, RowNumber, Scene, Up,
};
pub use error::SceneError;
pub use frame::UnitsAndUp;
pub(crate) use json::kind_of;
pub use json::{FORMAT, VERSION};
pub use lesson::{Goal, GoalOf, Lesson, Lock};
pub(crate) use panels::all_faces;
pub use panels::{
    Forecast, ForecastOfKind, HowFar, MeshSuggestion, PanelOffer, is_mostly_triangles,
    offers_new_panels, panel_adjective, panel_offers, panel_suggestion, problem_suggestion,
};
pub use presentation::{Slide, Variant, Variants};
pub use presets::{PRESETS, Preset, PresetOffer};
pub use results::{GoalResult, Results};
pub(crate) use validate::check_tolerance;
pub use words::NamedEnum;
