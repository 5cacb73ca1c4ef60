//! The session that every host drives: open, edit, drag, step, undo, report.
//!
//! A session holds one mesh and one document (constraints, handles, weights), and a solver for
//! it. Every edit is one step of undo; iterating from one point to another is one step too.
//!
//! | file or folder | holds |
//! |---|---|
//! | `state` | the session and what it holds |
//! | `load` | a scene opened, alone or in the place of another |
//! | `edit` | edits, settings, remedies |
//! | `undo` | edits made and taken back; drags and runs, one step of undo each |
//! | `run` | iterations |
//! | `selection` | selecting by what the mesh is like |
//! | `report` | measures, reports, lists of the worst |
//! | `export` | the current state as OBJ and as a scene |

mod edit;
mod export;
mod load;
mod report;
mod run;
mod selection;
mod state;
mod undo;

pub use edit::{
    ConstraintTarget, Edit, NewConstraint, Preview, Remedies, Remedy, SETTINGS, Setting,
    settings_of,
};
pub use report::{
    ConstraintMap, EnergyReport, FACE_MEASURES, FaceMeasure, GoalWords, MeasureUnit, Moved,
    Projections, Report, Seconds, Shape, Verdict, WorstElement, ZERO_SIZE_FACES, check_results,
    flaw_of, goals_in_words,
};
pub use run::{FittedCount, HalfStep, Step, max_interactive_faces};
pub use selection::{Mode, OPERATIONS, Operation, SelectRequest, Selection};
pub use state::{Collapse, CollapseReason, ResolvedRow, Session, TraceEntry};
pub use undo::check_targets;
