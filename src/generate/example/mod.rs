//! The example scenes: twelve models to begin with, of which four have new panels on free-form
//! surfaces, then the figures of the paper, whose numbers begin their ids, lessons, and other uses.
//!
//! | file or folder | holds |
//! |---|---|
//! | `declaration` | the texts of an example, and how it is built |
//! | `scene` | the list of examples, and the scene of each |
//! | `files` | the files of the examples |

mod declaration;
mod files;
mod scene;

pub use declaration::Example;
pub use files::{example_file, example_files};
pub use scene::EXAMPLES;
