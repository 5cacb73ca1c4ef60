//! A build in space: the shape with its offset and beams.
//!
//! | file | holds |
//! |---|---|
//! | `solids` | panels, offset and beams as groups of one mesh |
//! | `layers` | panels, offset, beams, node axes and sheets on layers, for CAD programs |
//! | `presentation` | shape, offset and beams as one coloured file |

mod layers;
mod presentation;
mod solids;

pub use layers::SpatialPart;
pub use presentation::PRESENTATION;
pub(super) use solids::solids;
