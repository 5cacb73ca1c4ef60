//! Picking: elements under the cursor, and the depth in front.
//!
//! | file | holds |
//! |---|---|
//! | `pick` | the nearest vertex, the face under the cursor |
//! | `ray` | a ray against triangles |
//! | `depth_map` | a small depth buffer of the mesh |

pub mod depth_map;
pub mod pick;
pub mod ray;

pub use depth_map::DepthMap;
pub use ray::hidden;
