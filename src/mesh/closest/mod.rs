//! Closest points on a surface (`c(v)` of Eq. 11) and on its boundary curves.
//!
//! | file | holds |
//! |---|---|
//! | `surface` | the surface as triangles, and the search |
//! | `bvh` | bounding volume hierarchy over the triangles |
//! | `triangle` | the closest point of one triangle |
//! | `neighbourhoods` | per triangle the region above and below it where it is closest |
//! | `safe_region` | that region, bounded by the triangles around |
//! | `point_cache` | per point the triangle that was closest last, and its region |
//! | `boundary_curves` | the boundary loops as curves to glide on, with corners |
//! | `polyline` | a polyline by its arc length |

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
