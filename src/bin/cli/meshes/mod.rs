//! The commands that make meshes, and meshes as files.
//!
//! | file | holds |
//! |---|---|
//! | `mesh_file` | a solved mesh as a file, by the ending of its name |
//! | `new_mesh` | the command `new`, with its arguments |
//! | `edit` | the command `edit`, with its arguments |
//! | `refine` | the command `refine` |

pub(super) mod edit;
pub(super) mod mesh_file;
pub(super) mod new_mesh;
pub(super) mod refine;
