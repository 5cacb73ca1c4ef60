//! The session that every host drives: open, edit, drag, step, undo, report.
//!
//! A session consists of one mesh, one document (constraints, handles, weights) and its solver.
//! Every edit is one step of undo, and so is every run of iterations.
//!
//! # A press
//!
//! A mesh that is opened keeps its shape: its weights are 1000 for the constraints, 1 for closeness to
//! the original and 1 for the smoothness of the change; a scene says its own. The tolerance is a
//! thousandth of the mean edge unless the user says otherwise; scenes and links keep it.
//!
//! "Make panels circular" (on the command line `solve --panels circle --within auto`) asks all panels
//! for it within the tolerance. If the shape found is not good (panels missed, faces folded, the
//! surface, the boundary or the panels moved by more than a fifth of an edge, or rougher), others are
//! tried: smoother displacements, exact panels, another start, panels that slide along the surface.
//! Panels that would still fold get a larger tolerance, at most 0.3 of the edge. The verdict says first
//! what is not good, and offers what ends better, with its number. `--within LENGTH` and `--exact`
//! apply to all panels unchanged.
//!
//! # Files
//!
//! | file or folder | holds |
//! |---|---|
//! | `composition` | the session: its parts, and plain access to them |
//! | `load` | opening a scene, also in place of another |
//! | `opened_file` | reading a file that the user opens: a mesh with its scene, or a scene with its mesh |
//! | `editing` | edits, undo and redo, and restoring them after a restart |
//! | `panel_layout` | new panels along the lines of curvature, in place of the mesh |
//! | `dragging` | drags and runs, one step of undo each |
//! | `iterating` | iterations, whole and in halves |
//! | `hard_constraints` | meeting hard constraints, during a run or at once |
//! | `requirements` | the requirements of constraints, and how far the shape is from them |
//! | `searching` | the attempts to meet hard constraints |
//! | `variations` | ways to change the shape while hard constraints stay met: shown, projected back, kept |
//! | `variant_table` | the numbers of the kept variants |
//! | `measured` | measures of the current shape, each computed once |
//! | `queries` | queries of hosts: offers, distances, reports, flat maps |
//! | `handed_in` | the results of a lesson, and their check |
//! | `trial` | suggestions, and the cost of exactness, tried on a copy |
//! | `state` | the parts: the rest mesh, and the scene with its solver; their states |
//! | `run` | the parts: progress, meeting of hard constraints, and what is told of a collapse |
//! | `undo` | the parts: the history, and the drag or run under way |
//! | `edit` | the edits and their effects, settings, offers |
//! | `selection` | selecting by properties of the mesh |
//! | `report` | measures, reports, worst elements |
//! | `error` | the error type of hosts |
//! | `export` | the current state as OBJ and as a scene |

mod composition;
mod dragging;
mod edit;
mod editing;
mod error;
mod export;
mod handed_in;
mod hard_constraints;
mod iterating;
mod load;
mod measured;
mod opened_file;
mod panel_layout;
mod queries;
mod report;
mod requirements;
mod run;
mod searching;
mod selection;
mod state;
mod trial;
mod undo;
mod variant_table;
mod variations;

pub use crate::solve::Moved;
pub use composition::Session;
pub use dragging::DragPhase;
pub use edit::{
    ConstraintOffer, ConstraintOffers, ConstraintTarget, Edit, NewConstraint, OfferedKind,
    OfferedOperation, OfferedPlace, OfferedStart, PanelStart, Refinement, Remeshing,
    RemeshingPreview, SETTINGS, Setting, SomeWeights, UnusedCloseness, settings_of,
};
pub use error::Error;
pub use handed_in::{Checked, check_results};
pub use opened_file::{FileReader, Guessed, OpenedFile, is_scene, named_files};
pub use panel_layout::{
    BoundaryForecast, LayoutNote, LayoutSettings, MarkedPlace, PanelLayout, PanelLayouts,
};
pub use report::{
    ConstraintMap, EasedPanels, EndWords, EnergyReport, ExactWords, FACE_MEASURES, FOLDED_FACES,
    FaceMeasure, GoalProgress, GoalWords, LessonProgress, Projections, Report, RowPalette,
    RunVerdict, Seconds, Shape, TrialWords, Unpaired, Verdict, VerdictWords, WeakerRequirement,
    WorstElement, ZERO_SIZE_FACES, flaw_of, goals_in_words, tolerance_of,
};
pub use run::{
    Bend, BendChange, Collapse, CollapseReason, Eased, ExactReport, FittedCount, Flaw, HalfStep,
    Level, Step, SurfaceDistance, TraceEntry, Tried, max_interactive_faces,
};
pub use selection::{Mode, OPERATIONS, Operation, SelectRequest, Selection};
pub use state::{Paired, ResolvedRow, check_targets};
pub use trial::{
    BetterPress, BetterPresses, Cost, ExactOffer, ExactShape, ExactTrial, Suggestion, Suggestions,
    VerdictReport,
};
pub use variant_table::VariantRow;
pub use variations::{Variations, Varied};
