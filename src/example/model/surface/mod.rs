//! Surfaces: roofs, shells, towers and sheets.
//!
//! | file | makes |
//! |---|---|
//! | `canopy`, `dome`, `hypar` | the models that the page shows first |
//! | `court` | a roof around a court |
//! | `hall` | a flowing roof with a swelling and a waist |
//! | `honeycomb` | hexagons over a height field |
//! | `lantern` | a surface of revolution, whose panels are circular |
//! | `mask` | a face in relief, of uneven triangles |
//! | `mounds` | a roof of polygons with two mounds |
//! | `net` | a piece of a torus, whose lines of edges are circles |
//! | `patch` | a sheet of skew, uneven quads |
//! | `strip` | a strip between two rails |
//! | `tower` | a tower whose floors are wavy |
//! | `vase` | a vase of triangles, not quite round |

mod canopy;
mod court;
mod dome;
mod hall;
mod honeycomb;
mod hypar;
mod lantern;
mod mask;
mod mounds;
mod net;
mod patch;
mod strip;
mod tower;
mod vase;

pub use canopy::Canopy;
pub use court::Court;
pub use dome::Dome;
pub use hall::Hall;
pub use honeycomb::honeycomb;
pub(crate) use honeycomb::{hexagons, triangle_rows};
pub use hypar::Hypar;
pub use lantern::Lantern;
pub use mask::Mask;
pub use mounds::Mounds;
pub use net::Net;
pub use patch::Patch;
pub use strip::Strip;
pub use tower::Tower;
pub use vase::Vase;
