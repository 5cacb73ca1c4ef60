//! A place on the shape: marked by a ring, and framed with what is around it.

use crate::math::{Vec3, cosine, sine, twice_vector_area};
use crate::mesh::{Mesh, Point, Surface};

/// Number of points of a ring.
const POINTS: usize = 32;
/// What is within this many radii of a ring is around its place.
const AROUND: f64 = 2.0;
/// A point of a ring that is farther than this many radii from the surface is not on it: beside a
/// boundary, or around what is smaller than the ring.
const BESIDE: f64 = 0.4;

/// A place on the shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MarkedPlace {
    /// A closed line around it, over the surface where there is one.
    pub ring: Vec<Point>,
    /// The vertices of the mesh around it, at least the corners of its face.
    pub around: Vec<u32>,
}

impl MarkedPlace {
    /// The place of a point, with a ring of this radius.
    pub(super) fn new(at: Vec3<f64>, radius: f64, surface: &Surface, shape: &Mesh) -> MarkedPlace {
        let corners = surface.closest_face(at.into()).map(|face| shape.faces.row(face as usize));
        let corners = corners.unwrap_or_default();
        let point = |v: u32| Vec3::from(shape.positions[v as usize]);
        let area = twice_vector_area(corners.iter().map(|&v| point(v)));
        // A face without area counts as level.
        let normal = area.length_and_direction().1.unwrap_or(Vec3::new(0.0, 0.0, 1.0));
        let first = normal.across();
        let second = normal.cross(first);
        let mut hint = Surface::NO_HINT;
        let ring = (0..=POINTS).map(|k| {
            let turn = (k % POINTS) as f64 / POINTS as f64;
            let [c, s] = [cosine(turn), sine(turn)];
            let point = at + (first * c + second * s) * radius;
            let over = surface.closest(point.into(), &mut hint);
            let is_beside = (Vec3::from(over) - point).length() > BESIDE * radius;
            if is_beside { point.into() } else { over }
        });
        let near = |v: &u32| (point(*v) - at).length() <= AROUND * radius;
        let mut around: Vec<u32> = corners.to_vec();
        around.extend(shape.faces.indices().iter().copied().filter(near));
        around.sort_unstable();
        around.dedup();
        MarkedPlace { ring: ring.collect(), around }
    }
}
