//! Tools that the generators share.
//!
//! | file | holds |
//! |---|---|
//! | `dual` | the polygon mesh dual to rows of triangles |
//! | `grid` | a grid of quads over a square |
//! | `noise` | a reproducible sequence of pseudo-random numbers |
//! | `opening` | removes faces |
//! | `relax` | moves vertices towards the mean of their neighbours |
//! | `rings` | vertices in rings one above another |
//! | `rounding` | coordinates in whole tenths of a millimetre |

mod dual;
mod grid;
mod noise;
mod opening;
mod relax;
mod rings;
mod rounding;

pub(crate) use dual::dual;
pub(crate) use grid::grid;
pub(crate) use noise::Noise;
pub use opening::opened;
pub(crate) use relax::slide;
pub use relax::soften;
pub(crate) use rings::Rings;
pub(crate) use rounding::rounded;
