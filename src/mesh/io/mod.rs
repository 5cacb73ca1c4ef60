//! Reading and writing mesh files: OBJ, OFF and Medit.
//!
//! | file | holds |
//! |---|---|
//! | `read` | reading any known format, recognised by name or content |
//! | `obj`, `groups`, `off`, `medit` | one reader each; the groups of OBJ |
//! | `lines`, `stream`, `number` | text, rows and numbers, for all formats |
//! | `builder` | the mesh while it is read, with its problems |
//! | `outcome` | the result of reading: a mesh with problems and notes, or an error |
//! | `obj_write`, `medit_write` | writing OBJ and Medit |
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
pub(crate) use lines::{decode, lines};
pub use medit_write::write_medit;
pub use obj_write::{write_obj, write_obj_with_uv};
pub use outcome::{Read, ReadError};
pub use read::read;
