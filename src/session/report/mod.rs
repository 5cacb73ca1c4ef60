//! Measures and reports of a scene and its shape.
//!
//! | file | holds |
//! |---|---|
//! | `run_report` | the report of a solved scene |
//! | `moved` | how far vertices moved, how much edges shrank |
//! | `verdict` | how many panels are as asked, within which tolerance |
//! | `face_measure` | the numbers per face that hosts colour and list |
//! | `shape_measures` | measures of the current shape, each computed once |
//! | `angles` | the angles at the corners of the faces |
//! | `tables` | errors and energies as CSV |
//! | `worst` | the elements that are farthest from what is asked of them |
//! | `projected` | the projections of the constraints, to be drawn |
//! | `constraint_map` | which row of constraints each face and vertex belongs to |
//! | `inspect` | members and measure of a row; what is close or fixed otherwise |
//! | `free` | vertices that nothing acts on |
//! | `mesh_diagnostics` | elements of the mesh that have a problem |
//! | `lesson` | the goals of a lesson, and the results that are handed in |

mod angles;
mod constraint_map;
mod face_measure;
mod free;
mod inspect;
mod lesson;
mod mesh_diagnostics;
mod moved;
mod projected;
mod run_report;
mod shape_measures;
mod tables;
mod verdict;
mod worst;

pub use constraint_map::ConstraintMap;
pub use face_measure::{FACE_MEASURES, FaceMeasure, MeasureUnit, Shape};
pub(crate) use lesson::check_lesson;
pub use lesson::{GoalWords, check_results, goals_in_words};
pub use mesh_diagnostics::{ZERO_SIZE_FACES, flaw_of};
pub use moved::Moved;
pub use projected::Projections;
pub use run_report::{EnergyReport, Report, Seconds};
pub use verdict::Verdict;
pub use worst::WorstElement;
