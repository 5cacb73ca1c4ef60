//! Computed meshes of the examples. Lengths are in metres, `z` points up. Only `+ - * / sqrt` are
//! used, so that every machine computes the same bits.
//!
//! | folder | holds |
//! |---|---|
//! | `surface` | roofs, shells, towers, sheets |
//! | `solid` | blocks, bodies, points |
//! | `tool` | helpers shared by the generators |

mod solid;
mod surface;
mod tool;

pub use solid::{Archway, Blocks, Creature, Pavilion};
pub use surface::{
    Canopy, Court, Dome, Hall, Hypar, Lantern, Mask, Mounds, Net, Patch, Strip, Tower, Vase,
    honeycomb,
};
pub(crate) use surface::{hexagons, triangle_rows};
pub(crate) use tool::{Noise, Rings, grid};
pub use tool::{opened, soften};
