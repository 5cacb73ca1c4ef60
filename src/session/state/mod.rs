//! The open scene, and its states.
//!
//! | file | holds |
//! |---|---|
//! | `rest_mesh` | the rest mesh: as opened, or derived from the opened one |
//! | `rows` | rows of constraints: selectors resolved, elements that do not fit counted |
//! | `handles` | handles as listed in a scene, and as stored in the solver; the check of their targets |
//! | `comparison` | what differs between two documents |
//! | `scene_state` | a state: document, handles, positions; the draft by which an edit makes the next one |
//! | `solved_scene` | document, resolved rows and solver, kept in step |

mod comparison;
mod handles;
mod rest_mesh;
mod rows;
mod scene_state;
mod solved_scene;

pub(crate) use comparison::{asks_otherwise, other_sets, same_problem, uses};
pub use handles::check_targets;
pub(crate) use handles::{flat, grouped};
pub(crate) use rest_mesh::RestMesh;
pub use rows::{Paired, ResolvedRow};
pub(crate) use rows::{acts, edges_among, resolve_row, resolve_rows};
pub(crate) use scene_state::{Draft, SceneState, same_document, same_handles, same_positions};
pub(crate) use solved_scene::SolvedScene;
