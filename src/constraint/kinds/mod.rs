//! The projection operators, one file each, and the list of them.
//!
//! Each line declares the module of a kind and adds it to [`Kind`]; nothing else needs to know the
//! kind. (`cargo fmt` does not find modules declared by a macro; `npm test` passes them to it.)
//!
//! | file or folder | holds |
//! |---|---|
//! | `registry` | the enum of kinds, generated from the list |
//! | `shared` | parts of several operators |

#[macro_use]
mod registry;
mod shared;

pub use registry::KindVisitor;

use super::declaration::Info;
use super::parameter::{self, KindError};
use super::projection::Projection;
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
