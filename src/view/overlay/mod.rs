//! Overlays: everything drawn beside the mesh.
//!
//! | file | holds |
//! |---|---|
//! | `surroundings` | the ghost of the original, and the ground |
//! | `ground` | the grid on the ground |
//! | `ground_shadow` | the shadow of the mesh on the ground |
//! | `layer` | a layer beside the surface |
//! | `surface_lines` | lines over the surface |
//! | `scale_bar` | a scale bar of round length |

pub mod ground;
pub mod ground_shadow;
pub mod layer;
pub mod scale_bar;
pub mod surface_lines;
pub mod surroundings;

pub use ground::Ground;
pub use ground_shadow::GroundShadow;
pub use layer::ShownLayer;
pub use scale_bar::scale_bar;
pub use surface_lines::SurfaceLines;
pub use surroundings::Surroundings;
