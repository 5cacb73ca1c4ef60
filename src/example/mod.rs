//! The example scenes and the generators of their meshes: first three models to play with, then the
//! figures of the paper, whose numbers begin their ids, and lessons.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | the texts of an example, and how it is built |
//! | `scene` | the list of examples, and the scene of each |
//! | `model` | the meshes |
//! | `suggestions` | plots of some examples that hosts offer |

mod declaration;
pub mod model;
mod scene;
mod suggestions;

pub use declaration::Example;
pub use scene::EXAMPLES;
pub use suggestions::{Suggestion, suggestions};
