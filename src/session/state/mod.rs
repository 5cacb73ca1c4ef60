//! The data of a session.
//!
//! | file | holds |
//! |---|---|
//! | `session` | the session, and plain access to it |
//! | `rows` | rows of constraints: selectors resolved, elements that do not fit counted |
//! | `setup` | the solver of a document |
//! | `handles` | handles as a scene lists them and as the solver has them |
//! | `same_problem` | whether two documents need different solvers |
//! | `run_state` | all that outlasts the solver: iterations, trace, history, guard |
//! | `history` | snapshots, steps of undo and redo |
//! | `transaction` | a drag or a run that is under way |
//! | `trace` | the energies of the iterations |
//! | `collapse` | whether a shape has collapsed since a start |
//! | `measured` | measures of one shape, kept while it stays |

mod collapse;
mod handles;
mod history;
mod measured;
mod rows;
mod run_state;
mod same_problem;
mod session;
mod setup;
mod trace;
mod transaction;

pub use collapse::{Collapse, CollapseReason};
pub(crate) use collapse::{Start, areas, diagonal};
pub(crate) use handles::{flat, grouped};
pub(crate) use history::{History, Snapshot};
pub(crate) use measured::Measured;
pub use rows::ResolvedRow;
pub(crate) use rows::{edges_among, resolve_rows};
pub(crate) use run_state::RunState;
pub(crate) use same_problem::same_problem;
pub use session::Session;
pub(crate) use setup::solver;
pub(crate) use trace::Trace;
pub use trace::TraceEntry;
pub(crate) use transaction::{PanelGoal, Transaction, TransactionKind};
