//! Closest points on a surface (`c(v)` of Eq. 11) and on its boundary curves.
//!
//! | file | holds |
//! |---|---|
//! | `surface` | the surface as triangles, and the search |
//! | `bvh` | bounding volume hierarchy over the triangles |
//! | `triangle` | the closest point of one triangle |
//! | `neighbourhoods` | nearby triangles and safe region of each triangle |
//! | `safe_region` | region above and below a triangle in which no other triangle is closer |
//! | `point_cache` | per point, the last closest triangle and its safe region |
//! | `boundary_curves` | the boundary loops as curves to glide on, and their corners |
//! | `polyline` | a polyline parametrised by arc length |

mod boundary_curves;
mod bvh;
mod neighbourhoods;
mod point_cache;
mod polyline;
mod safe_region;
mod surface;
mod triangle;

pub use boundary_curves::{BoundaryCurve, BoundaryCurves, BoundaryPiece};
pub use point_cache::ClosestPointCache;
pub use polyline::Polyline;
pub use surface::Surface;
