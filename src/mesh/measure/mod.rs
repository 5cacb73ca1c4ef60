//! Measures of a mesh.
//!
//! | file | holds |
//! |---|---|
//! | `face_measures` | planarity, circularity and diagonal ratio of faces |
//! | `face_fit` | the least-squares plane and circle of a face |
//! | `angle_histogram` | histogram of the corner angles of faces |
//! | `dihedral` | angles between neighbouring faces |
//! | `folds` | faces that a deformation has folded over |
//! | `gauss_curvature` | Gauss curvature at vertices |
//! | `histogram` | histogram of errors, for legends |
//! | `quasi_conformal` | angle distortion of a flat map |
//! | `unrolled` | strips of quads unrolled into the plane |

mod angle_histogram;
mod dihedral;
mod face_fit;
mod face_measures;
mod folds;
mod gauss_curvature;
mod histogram;
mod quasi_conformal;
mod unrolled;

pub use angle_histogram::angle_histogram;
pub use dihedral::mean_dihedral_angle;
pub use face_measures::{Circularity, Measures, Planarity, diagonal_ratio};
pub use folds::folded_faces;
pub use gauss_curvature::gauss_curvature;
pub use histogram::Histogram;
pub use quasi_conformal::{MapErrors, QuasiConformal, quasi_conformal};
pub use unrolled::UnrolledStrip;
