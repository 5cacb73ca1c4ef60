//! Quads along the lines of curvature of any surface: a cross field aligned with curvature, a seamless
//! map rounded to the integer grid, and the exact extraction of the grid.
//!
//! | file or folder | holds |
//! |---|---|
//! | `grid_map` | the triangulated surface and the integer-grid map, in fixed point |
//! | `options` | settings, stages, observer |
//! | `error` | why a surface cannot be remeshed |

mod error;
mod grid_map;
mod options;

pub use error::RemeshError;
pub use grid_map::{FRACTION_BITS, GridMap, Side, Transition, Triangulation, UNIT};
pub use options::{Boundary, MapOptions, PanelSize, RemeshObserver, RemeshStage};
