//! Two pictures on one canvas.
//!
//! | file | holds |
//! |---|---|
//! | `flat_map` | the flat map beside the model |
//! | `split` | the model twice |

pub mod flat_map;
pub mod split;

pub use flat_map::{Region, flat_map, follow, show_flipped};
pub use split::{Colours, Split};
