//! The contents of one canvas: one picture, or two.
//!
//! | file | holds |
//! |---|---|
//! | `flat_map` | the flat map beside the model |
//! | `split` | two pictures of the model |
//! | `pictures` | all pictures of a canvas, and how they share it |

pub mod flat_map;
pub mod pictures;
pub mod split;

pub use flat_map::{Region, flat_map, follow, show_flipped};
pub use pictures::Pictures;
pub use split::{Colours, Split};
