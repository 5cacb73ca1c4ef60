//! Small dense mathematics, used by all other modules. Only `+ - * / sqrt`, and `libm` for angles,
//! so that all platforms give the same bits.
//!
//! | file or folder | holds |
//! |---|---|
//! | `vector` | lanes, and 3-vectors of lanes |
//! | `eigen` | eigenvectors, principal axes and singular values of 3x3 matrices |
//! | `fit` | closest rotations, fitted circles and spheres, numbers with a given product |
//! | `polygon` | sides and corners of polygons, regular polygons |
//! | `plane` | points and vectors of the plane, area of a polygon |
//! | `angle`, `turns` | angles between directions; sine and cosine |
//! | `cube_root` | the cube root |
//! | `cubic` | a segment of a cubic curve, and its closest point |
//! | `argsort` | sorting by integer keys |
//! | `marks` | marked elements of a list |

mod angle;
mod argsort;
mod cube_root;
mod cubic;
mod eigen;
mod fit;
mod marks;
pub mod plane;
mod polygon;
mod turns;
mod vector;

pub use angle::angle;
pub use argsort::{argsort, key_of_number, key_of_pair, sort_by_number};
pub use cube_root::cube_root;
pub use cubic::Cubic;
pub use eigen::{
    Eigenvector, PrincipalAxes, Scatter, SingularValues, Symmetric3, orthonormalise,
    symmetric_eigen,
};
pub use fit::{
    Alignment, CircleFit, OrthogonalPair, PrincipalCircle, PrincipalRound, Round, RoundWithin,
    pair_with_product, pair_with_product_robust, triple_with_product, triple_with_product_robust,
};
pub use marks::marked;
pub use polygon::{UnitPolygon, plane_frame, polygon_corners, polygon_sides, twice_vector_area};
pub use turns::{cosine, cosine_and_sine_of_degrees, sine};
pub use vector::{LANES, Lane, Lanes, Pair, Vec3, centre, in_range, largest_coordinate};
