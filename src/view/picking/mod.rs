//! Picking of elements under the cursor, and visibility.
//!
//! | file | holds |
//! |---|---|
//! | `pick` | the nearest vertex, the face under the cursor |
//! | `ray` | intersection of rays with triangles |
//! | `depth_map` | a small depth buffer of the mesh |

pub mod depth_map;
pub mod pick;
pub mod ray;

pub use depth_map::DepthMap;
pub use ray::hidden;
