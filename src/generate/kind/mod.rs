//! New meshes by kind and sizes.

mod declaration;
mod list;
mod round;
mod sheets;

pub use declaration::{NewKind, NewMeshError};
pub use list::NEW_KINDS;
