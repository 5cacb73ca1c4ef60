//! Small dense mathematics, used by all other modules. Only `+ - * / sqrt`, and `libm`, so that all
//! platforms give the same bits.
//!
//! | file | holds |
//! |---|---|
//! | `lane`, `register` | one scalar, or the same scalar of several constraints side by side |
//! | `vec3` | 3-vectors of lanes |
//! | `symmetric3`, `eigenvector` | symmetric 3x3 matrices in lanes, and their eigenvectors in closed form |
//! | `principal`, `singular` | principal axes and singular values, accurate for every input |
//! | `dense` | eigenvectors and orthonormal vectors of any size |
//! | `alignment`, `orthogonal_pair` | the closest rotation and scale, the closest square frame |
//! | `round`, `round_within`, `circle_fit` | fitted circles and spheres |
//! | `nearest_centre` | the closest circle or sphere of a given radius, searched from many starts |
//! | `nearest_points` | the nearest of many points, and those within a length |
//! | `product` | the closest numbers with a given product |
//! | `polygon`, `unit_polygon` | sides and corners of polygons, regular polygons |
//! | `plane` | points and vectors of the plane, area of a polygon |
//! | `ears` | polygons as triangles |
//! | `elementary` | angles, sine and cosine, round numbers |
//! | `cubic` | a segment of a cubic curve, and its closest point |
//! | `indices` | sorting by integer keys, marked elements, lists of lists |
//! | `limited_memory` | the inverse of a Hessian from the last steps of a descent |

mod alignment;
mod circle_fit;
mod cubic;
mod dense;
mod ears;
mod eigenvector;
mod elementary;
mod indices;
mod lane;
mod limited_memory;
mod nearest_centre;
mod nearest_points;
mod orthogonal_pair;
pub mod plane;
mod polygon;
mod principal;
mod product;
mod register;
mod round;
mod round_within;
mod singular;
mod symmetric3;
mod unit_polygon;
mod vec3;

pub use alignment::Alignment;
pub use circle_fit::CircleFit;
pub use cubic::Cubic;
pub use dense::{orthonormalise, symmetric_eigen};
pub use ears::{
    ears, ears_in_space, is_diagonal_inside, is_seen_from_mean, triangles_in_space, turn,
};
pub use eigenvector::Eigenvector;
pub use elementary::{
    angle, angle_between, cosine, cosine_and_sine_of_degrees, grid_step, nearest_round, round_down,
    round_up, sine,
};
pub use indices::{Ragged, argsort, key_of_number, key_of_pair, marked, sort_by_number};
pub use lane::{LANES, Lane, Lanes, Pair};
pub use limited_memory::{LimitedMemory, add_scaled, inner_product};
pub use nearest_points::{Cells, NearestPoints};
pub use orthogonal_pair::OrthogonalPair;
pub use polygon::{plane_frame, polygon_corners, polygon_sides, twice_vector_area, visits_twice};
pub use principal::PrincipalAxes;
pub use product::{
    pair_with_product, pair_with_product_robust, triple_with_product, triple_with_product_robust,
};
pub use round::Round;
pub use round_within::{PrincipalRound, RoundWithin};
pub use singular::SingularValues;
pub use symmetric3::{Scatter, Symmetric3};
pub use unit_polygon::UnitPolygon;
pub use vec3::{Vec3, centre, in_range, largest_coordinate, mean};
