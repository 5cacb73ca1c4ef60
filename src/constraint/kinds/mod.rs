//! The projection operators, one file each, and the list of them.
//!
//! A line of the list is all that the project has to know of a kind: it declares the module and makes
//! the kind one of [`Kind`]. (So `cargo fmt` does not find these files by itself; `npm test` names them
//! to it.)
//!
//! | file or folder | holds |
//! |---|---|
//! | `registry` | the enum of kinds, made from the list |
//! | `shared` | what several operators are made of |

#[macro_use]
mod registry;
mod shared;

pub use registry::KindVisitor;

use super::declaration::Info;
use super::parameter::{self, KindError};
use super::projection::Projection;
use super::target_shape::TargetShape;
use crate::math::Vec3;

kinds! {
    line::Line,
    plane::Plane,
    circle::Circle,
    sphere::Sphere,
    line_segment::LineSegment,
    rigid::Rigid,
    similar::Similar,
    planar_similar::PlanarSimilar,
    regular_polygon::RegularPolygon,
    square::Square,
    parallelogram::Parallelogram,
    rectangle::Rectangle,
    angle::Angle,
    equal_length::EqualLength,
    area::Area,
    volume::Volume,
    bending::Bending,
    incircle::Incircle,
    tangent_incircles::TangentIncircles,
    conical::Conical,
    symmetry::Symmetry,
    on_curve::OnCurve,
    on_surface::OnSurface,
}
