//! Polygons.
//!
//! | file | holds |
//! |---|---|
//! | `corners` | sides and corners in order, vector area |
//! | `unit_polygon` | regular polygons on the unit circle |
//! | `plane_frame` | axes of the plane that two vectors span |

mod corners;
mod plane_frame;
mod unit_polygon;

pub use corners::{polygon_corners, polygon_sides, twice_vector_area};
pub use plane_frame::plane_frame;
pub use unit_polygon::UnitPolygon;
