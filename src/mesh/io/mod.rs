//! Mesh files in and out: OBJ, OFF and Medit.
//!
//! | file | holds |
//! |---|---|
//! | `read` | any known format in, told apart by name or content |
//! | `obj`, `groups`, `off`, `medit` | one format each; the groups of OBJ |
//! | `lines`, `stream`, `number` | text, rows and numbers, for all formats |
//! | `builder` | the mesh while it is read, with the problems met |
//! | `outcome` | what reading gives: a mesh and what there is to say of it, or an error |
//! | `obj_write`, `medit_write` | OBJ and Medit out |
//! | `decimal` | numbers as text that reads back to the same bits |

mod builder;
mod decimal;
mod groups;
mod lines;
mod medit;
mod medit_write;
mod number;
mod obj;
mod obj_write;
mod off;
mod outcome;
mod read;
mod stream;

pub use decimal::Decimal;
pub use medit_write::write_medit;
pub use obj_write::{write_obj, write_obj_with_uv};
pub use outcome::{Read, ReadError};
pub use read::read;
