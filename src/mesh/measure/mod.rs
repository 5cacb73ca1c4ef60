//! Numbers that describe a mesh.
//!
//! | file | holds |
//! |---|---|
//! | `face_measures` | planarity, circularity and diagonal ratio of faces |
//! | `face_fit` | the least-squares plane and circle of a face |
//! | `angle_histogram` | how many corners of faces have which angle |
//! | `folds` | faces that a change of shape has folded over |
//! | `gauss_curvature` | Gauss curvature at vertices |
//! | `histogram` | how errors are distributed, for legends |
//! | `quasi_conformal` | how far a flat map is from keeping angles |
//! | `unrolled` | strips of quads laid flat |

mod angle_histogram;
mod face_fit;
mod face_measures;
mod folds;
mod gauss_curvature;
mod histogram;
mod quasi_conformal;
mod unrolled;

pub use angle_histogram::angle_histogram;
pub use face_measures::{Circularity, Measures, Planarity, diagonal_ratio};
pub use folds::folded_faces;
pub use gauss_curvature::gauss_curvature;
pub use histogram::Histogram;
pub use quasi_conformal::{MapErrors, QuasiConformal, quasi_conformal};
pub use unrolled::UnrolledStrip;
