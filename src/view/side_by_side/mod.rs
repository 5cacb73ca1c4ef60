//! The contents of one canvas: the model, alone or with its flat map.
//!
//! | file | holds |
//! |---|---|
//! | `flat_map` | the flat map beside the model |
//! | `pictures` | both pictures, and how they share the canvas |

pub mod flat_map;
pub mod pictures;

pub use flat_map::{Region, flat_map, follow, show_flipped};
pub use pictures::Pictures;
