//! The open scene, and its changes.
//!
//! | file | holds |
//! |---|---|
//! | `rest_mesh` | the rest mesh: as opened, or derived from the opened one |
//! | `rows` | rows of constraints: selectors resolved, elements that do not fit counted |
//! | `handles` | handles as listed in a scene, and as stored in the solver; the check of their targets |
//! | `part` | parts of a document, which are exchanged with it |
//! | `scene_change` | the difference of two states: parts, handles, positions; the draft by which an edit makes one |
//! | `solved_scene` | document, resolved rows and solver, kept in step |

mod handles;
mod part;
mod rest_mesh;
mod rows;
mod scene_change;
mod solved_scene;

pub use handles::check_targets;
pub(crate) use handles::{flat, grouped};
pub use part::as_asked;
pub(crate) use part::{Part, RowValues, Settings, leave_search, same_problem, uses};
pub(crate) use rest_mesh::RestMesh;
pub use rows::{Paired, ResolvedRow};
pub(crate) use rows::{acts, edges_among, resolve_row, resolve_rows};
pub(crate) use scene_change::{Draft, SceneChange, same_positions};
pub(crate) use solved_scene::SolvedScene;
