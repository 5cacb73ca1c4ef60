//! Small dense mathematics under everything else: lanes, 3-vectors of lanes, symmetric 3x3
//! eigenvectors, singular values, principal axes, closest rotations, fitted circles and spheres,
//! regular polygons, the sides and corners of any, closest numbers with a given product, angles, sines
//! and cube roots, and sorting.
//! Knows of nothing else in the crate.

mod alignment;
mod angle;
mod ascending;
mod circle_fit;
mod eigenvector;
mod jacobi;
mod lane;
mod orthogonal_pair;
mod plane_frame;
mod polygon;
mod principal;
mod product;
mod root;
mod round;
mod round_within;
mod singular;
mod symmetric3;
mod turns;
mod unit_polygon;
mod vec3;

pub use alignment::Alignment;
pub use angle::angle;
pub use ascending::{ascending, key_of_number, key_of_pair};
pub use circle_fit::{CircleFit, PrincipalCircle};
pub use eigenvector::Eigenvector;
pub use jacobi::symmetric_eigen;
pub use lane::{LANES, Lane, Lanes, Pair};
pub use orthogonal_pair::OrthogonalPair;
pub use plane_frame::plane_frame;
pub use polygon::{polygon_corners, polygon_sides, twice_vector_area};
pub use principal::PrincipalAxes;
pub use product::{
    pair_with_product, pair_with_product_carefully, triple_with_product,
    triple_with_product_carefully,
};
pub use root::cube_root;
pub use round::Round;
pub use round_within::{PrincipalRound, RoundWithin};
pub use singular::SingularValues;
pub use symmetric3::{Scatter, Symmetric3};
pub use turns::{cosine, cosine_and_sine_of_degrees, sine};
pub use unit_polygon::UnitPolygon;
pub use vec3::{Vec3, centre};
