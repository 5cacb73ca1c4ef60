//! Measures, reports and diagnostics.
//!
//! | file | holds |
//! |---|---|
//! | `run_report` | the report of the command line |
//! | `verdict` | how many panels have the required shape within a tolerance |
//! | `verdict_words` | the same in words |
//! | `run_verdict` | how a run ended, and whether its constraints are met, in words |
//! | `exact_words` | how well hard constraints are met, and what exactness costs, in words |
//! | `face_measure` | the measures of faces, by which hosts colour and list them |
//! | `measuring` | the shapes to be measured |
//! | `tables` | errors, energies and angles as CSV |
//! | `worst` | the elements that are farthest from their constraints |
//! | `projected` | the projections of the constraints, for drawing |
//! | `constraint_map` | the row of constraints of each face and vertex |
//! | `inspect` | members and measure of a row; vertices with a closeness factor, or without any energy |
//! | `mesh_diagnostics` | elements of the mesh that have a problem |
//! | `lesson` | the goals of a lesson |

mod constraint_map;
mod exact_words;
mod face_measure;
mod inspect;
mod lesson;
mod measuring;
mod mesh_diagnostics;
mod projected;
mod run_report;
mod run_verdict;
mod tables;
mod verdict;
mod verdict_words;
mod worst;

pub(crate) use constraint_map::ConstraintCoverage;
pub use constraint_map::{ConstraintMap, RowPalette};
pub use exact_words::{ExactWords, TrialWords, WeakerRequirement};
pub(crate) use exact_words::{Exactness, TrialNumbers};
pub use face_measure::{FACE_MEASURES, FaceMeasure};
pub(crate) use inspect::panel_row;
pub use lesson::{GoalProgress, GoalWords, LessonProgress, goals_in_words};
pub(crate) use lesson::{check_lesson, check_presentation};
pub use measuring::Shape;
pub use mesh_diagnostics::{FOLDED_FACES, ZERO_SIZE_FACES, flaw_of};
pub use projected::Projections;
pub use run_report::{EnergyReport, Report, Seconds, Unpaired};
pub use run_verdict::{EndWords, RunVerdict};
pub(crate) use verdict::tolerance;
pub use verdict::{EasedPanels, Verdict, tolerance_of};
pub use verdict_words::VerdictWords;
pub use worst::WorstElement;
