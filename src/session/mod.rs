//! The session that every host drives: open, edit, drag, step, undo, report.
//!
//! A session holds one mesh and one document (constraints, handles, weights), and a solver for
//! it. Every edit is one step of undo; iterating from one point to another is one step too.
//!
//! | file or folder | holds |
//! |---|---|
//! | `composition` | the session: its parts, and plain access to them |
//! | `load` | a scene opened, alone or in the place of another |
//! | `opened_file` | a file as somebody opens it: a mesh with its scene, or a scene with its mesh |
//! | `editing` | edits, undo and redo, and their restoring after a restart |
//! | `dragging` | drags and runs, one step of undo each |
//! | `iterating` | iterations, whole and in halves |
//! | `hard_constraints` | hard constraints met, during a run or at once |
//! | `requirements` | what is required of constraints, and how near the shape is to it |
//! | `unfolding` | other ways to meet them where faces fold |
//! | `variations` | ways to change the shape while hard constraints stay met: shown, brought back, kept |
//! | `variant_table` | the numbers of the shapes that were kept |
//! | `queries` | queries of hosts: selections, measures, reports, files |
//! | `handed_in` | the results of a lesson, and their check |
//! | `trial` | what would help and what it would cost, tried on a copy |
//! | `state` | the parts: the mesh at rest, and the scene with its solver; how that changes |
//! | `run` | the parts: progress and the guard against collapse |
//! | `undo` | the parts: the history, and the drag or run that is under way |
//! | `edit` | the edits and their effects, settings, previews |
//! | `selection` | selecting by what the mesh is like |
//! | `report` | measures, reports, lists of the worst |
//! | `export` | the current state as OBJ and as a scene |

mod composition;
mod dragging;
mod edit;
mod editing;
mod export;
mod handed_in;
mod hard_constraints;
mod iterating;
mod load;
mod opened_file;
mod queries;
mod report;
mod requirements;
mod run;
mod selection;
mod state;
mod trial;
mod undo;
mod unfolding;
mod variant_table;
mod variations;

pub use crate::solve::Moved;
pub use composition::Session;
pub use dragging::DragPhase;
pub use edit::{
    ConstraintTarget, Edit, NewConstraint, OfferedOperation, Preview, Refinement, Remeshing,
    RemeshingPreview, SETTINGS, Setting, settings_of,
};
pub use handed_in::{Checked, check_results};
pub use opened_file::{FileReader, Guessed, OpenedFile, is_scene, named_files};
pub use report::{
    ConstraintMap, EasedPanels, EnergyReport, FACE_MEASURES, FOLDED_FACES, FaceMeasure, GoalWords,
    MeasureUnit, Projections, Report, RowPalette, Seconds, Shape, Unpaired, Verdict, WorstElement,
    ZERO_SIZE_FACES, flaw_of, goals_in_words,
};
pub use run::{
    Collapse, CollapseReason, Eased, ExactReport, FittedCount, HalfStep, Step, TraceEntry,
    max_interactive_faces,
};
pub use selection::{Mode, OPERATIONS, Operation, SelectRequest, Selection};
pub use state::{Paired, ResolvedRow};
pub use trial::{ExactOffer, ExactTrial, Price, Remedies, Remedy};
pub use undo::check_targets;
pub use variant_table::VariantRow;
pub use variations::Variations;
