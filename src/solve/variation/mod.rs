//! The shape space of a shape whose hard constraints are met: its softest variations that keep them
//! met (the tangent space of Yang, Yang, Pottmann, Mitra 2011, from projections only), and the
//! return onto the constraints after a step along them.
//!
//! The energy is that of smoothness of the displacement, and a little of the displacement itself.
//! One factor of the block system serves all modes; a step needs another one, and a few triangular
//! sweeps.
//!
//! | file | holds |
//! |---|---|
//! | `motions` | translations, rotations and scaling, which are not variations |
//! | `subspace` | the iteration for the softest directions |
//! | `mirror` | planes of symmetry |
//! | `modes` | the modes that are shown |
//! | `shape_space` | the modes of a shape, and steps along them |

mod mirror;
mod modes;
mod motions;
mod shape_space;
mod subspace;

pub use modes::{SLIDE, Variation};
pub use shape_space::{Reached, ShapeSpace};
