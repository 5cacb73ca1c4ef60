//! Eigenvectors and singular values of small matrices.
//!
//! | file | holds |
//! |---|---|
//! | `symmetric3` | symmetric 3x3 matrices in lanes, scatter matrices |
//! | `eigenvector` | closed-form eigenvectors in lanes |
//! | `jacobi` | eigenvalues and eigenvectors by Jacobi rotations |
//! | `principal` | principal axes of points, accurate for every input |
//! | `singular` | singular values of 3x3 matrices |

mod eigenvector;
mod jacobi;
mod principal;
mod singular;
mod symmetric3;

pub use eigenvector::Eigenvector;
pub use jacobi::symmetric_eigen;
pub use principal::PrincipalAxes;
pub use singular::SingularValues;
pub use symmetric3::{Scatter, Symmetric3};
