//! Small dense mathematics under everything else: lanes, 3-vectors of lanes, symmetric 3x3
//! eigenvectors, principal axes, closest rotations, fitted circles and spheres, regular polygons.
//! Knows of nothing else in the crate.

mod alignment;
mod circle_fit;
mod eigenvector;
mod lane;
mod orthogonal_pair;
mod principal;
mod round;
mod round_within;
mod symmetric3;
mod turns;
mod unit_polygon;
mod vec3;

pub use alignment::Alignment;
pub use circle_fit::{CircleFit, PrincipalCircle};
pub use eigenvector::Eigenvector;
pub use lane::{LANES, Lane, Lanes, Pair};
pub use orthogonal_pair::OrthogonalPair;
pub use principal::PrincipalAxes;
pub use round::Round;
pub use round_within::{PrincipalRound, RoundWithin};
pub use symmetric3::{Scatter, Symmetric3};
pub use turns::{cosine, sine};
pub use unit_polygon::UnitPolygon;
pub use vec3::{Vec3, centre};
