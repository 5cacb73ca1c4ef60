//! The contents of one canvas: a picture, or two.
//!
//! | file | holds |
//! |---|---|
//! | `flat_map` | the flat map beside the model |
//! | `split` | the model twice |
//! | `pictures` | all that is on the canvas, and how it shares it |

pub mod flat_map;
pub mod pictures;
pub mod split;

pub use flat_map::{Region, flat_map, follow, show_flipped};
pub use pictures::Pictures;
pub use split::{Colours, Split};
