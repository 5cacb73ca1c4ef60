//! Eigenvectors and singular values of small matrices.
//!
//! | file | holds |
//! |---|---|
//! | `symmetric3` | symmetric 3x3 matrices in lanes, scatter matrices |
//! | `eigenvector` | closed-form eigenvectors in lanes |
//! | `dense` | eigenvectors and orthonormal vectors of any size |
//! | `principal` | principal axes of points, accurate for every input |
//! | `singular` | singular values of 3x3 matrices |

mod dense;
mod eigenvector;
mod principal;
mod singular;
mod symmetric3;

pub use dense::{orthonormalise, symmetric_eigen};
pub use eigenvector::Eigenvector;
pub use principal::PrincipalAxes;
pub use singular::SingularValues;
pub use symmetric3::{Scatter, Symmetric3};
