//! Single panels: laid flat, with the joint subtracted, named, sorted into types.
//!
//! | file | holds |
//! |---|---|
//! | `plane` | least-squares planes |
//! | `polygon` | polygons in the plane: perimeter, hull, the roomiest point for a label |
//! | `flat` | a panel laid flat, with its errors |
//! | `inset` | subtraction of the joint |
//! | `name` | short, stable names of panels |
//! | `triangles` | a polygon as triangles, shortest diagonals first |
//! | `alike` | types of panels |

mod alike;
mod flat;
mod inset;
mod name;
mod plane;
mod polygon;
mod triangles;

pub use alike::panel_types;
pub use flat::{FlatPanel, lay_flat};
pub use inset::inset;
pub use name::panel_names;
pub(super) use plane::plane_distance;
pub(super) use polygon::smallest_box_within;
pub(super) use polygon::{direction_of, distance_to_outline, sides};
pub use polygon::{hull, is_simple, perimeter, roomiest_point, smallest_box};
pub(super) use triangles::{triangles, triangles_in_space, turn};
