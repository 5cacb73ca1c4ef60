//! Meshes made from meshes.
//!
//! | file | holds |
//! |---|---|
//! | `weld` | vertices at one place made one, where faces have their own |

mod weld;

pub use weld::Weld;
