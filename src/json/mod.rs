//! JSON: text to a tree, a tree to typed values, and a tree to text.
//!
//! Scene files, edits and the parameters of kinds are serde types. One deserializer reads all of
//! them, so that each type is compiled once; it tracks the JSON path itself.
//!
//! | file | holds |
//! |---|---|
//! | `tree` | the tree |
//! | `parse` | text to a tree |
//! | `read` | a tree to serde types |
//! | `error` | an error with its JSON path |
//! | `indices` | lists of indices: arrays, or strings of ranges |

mod error;
pub(crate) mod indices;
mod parse;
mod read;
mod tree;

pub(crate) use error::{JsonError, found, push_key};
pub(crate) use parse::parse;
pub(crate) use read::{present, read, read_tree};
pub(crate) use tree::Tree;
