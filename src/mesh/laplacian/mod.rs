//! The weights `w_ij` of the smoothness energy (paper section 4, Eq. 12).
//!
//! | file | holds |
//! |---|---|
//! | `weights` | the weights of a mesh: uniform, cotangent, polygon |
//! | `cotangent` | clamped cotangents of angles |
//! | `polygon_weights` | the weights of a polygon with any number of corners |

mod cotangent;
mod polygon_weights;
mod weights;

pub use cotangent::LARGEST_COTANGENT;
pub use weights::Laplacian;
