//! The commands that make meshes, and mesh files of sessions.
//!
//! | file | holds |
//! |---|---|
//! | `mesh_file` | mesh files of sessions, with the format by extension |
//! | `new_mesh` | the command `new`, with its arguments |
//! | `edit` | the command `edit`, with its arguments |
//! | `refine` | the command `refine` |

pub(super) mod edit;
pub(super) mod mesh_file;
pub(super) mod new_mesh;
pub(super) mod refine;
