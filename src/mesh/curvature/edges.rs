//! The angles between the edges of a mesh and the lines of curvature of its surface.
//!
//! The edges of quads with circumcircles tend to the lines of curvature as the quads become small (Bobenko and
//! Suris 2008, Liu et al. 2006): where they lie otherwise, the mesh has to turn them to become circular.

use super::principal::{Curvature, curvatures};
use crate::math::{Vec3, angle, polygon_sides};
use crate::mesh::{Point, Ragged, Topology};

/// The difference of the principal curvatures as a part of the sum of their sizes below which they are taken to be
/// equal: what is left then is the error of the fit.
pub(super) const UMBILIC: f64 = 0.2;
/// An edge that turns by less than this over its length, in radians, is on a surface that is flat there.
pub(super) const FLAT: f64 = 1e-3;

/// The edges of faces against the principal directions of the surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurvatureLines {
    /// Per edge of [`Topology::edges`] its angle to the nearest principal direction, degrees from 0 to 45; not a
    /// number where the surface has none (it is flat, or a sphere) or where it is not known.
    pub angles: Vec<f64>,
    /// The mean of the angles by the lengths of their edges; none where no edge has an angle.
    pub mean: Option<f64>,
    /// The part of all edges, by length, that has an angle.
    pub directed: f64,
}

impl CurvatureLines {
    /// Measures the edges at `positions`, `#V by 3`.
    pub fn new(positions: &[Point], faces: &Ragged, topology: &Topology) -> CurvatureLines {
        let curvatures = curvatures(positions, faces, topology);
        let (mut angles, mut sum, mut known, mut whole) = (Vec::new(), 0.0, 0.0, 0.0);
        for (&[a, b], faces) in topology.edges().iter().zip(topology.edge_faces().iter()) {
            if faces.is_empty() {
                angles.push(f64::NAN);
                continue;
            }
            let along = Vec3::from(positions[b as usize]) - Vec3::from(positions[a as usize]);
            let ends = [a, b].map(|v| curvatures[v as usize]);
            let degrees = angle_to_principal(along, ends).unwrap_or(f64::NAN);
            let length = along.length();
            whole += length;
            if !degrees.is_nan() {
                sum += degrees * length;
                known += length;
            }
            angles.push(degrees);
        }
        CurvatureLines {
            angles,
            mean: (known > 0.0).then(|| sum / known),
            directed: if whole > 0.0 { known / whole } else { 0.0 },
        }
    }

    /// The mean angle of the sides of each face, `#F`, of those that have one, in degrees from 0 to 45; not a number
    /// where none has.
    pub fn of_faces(&self, faces: &Ragged, topology: &Topology) -> Vec<f64> {
        let mean = |face: &[u32]| {
            let sides = polygon_sides(face).filter_map(|[a, b]| topology.edge(a, b));
            let known = sides.map(|e| self.angles[e as usize]).filter(|angle| !angle.is_nan());
            let (sum, count) = known.fold((0.0, 0.0), |(sum, n), angle| (sum + angle, n + 1.0));
            if count > 0.0 { sum / count } else { f64::NAN }
        };
        faces.iter().map(mean).collect()
    }
}

/// In degrees; none where the mean of the two second fundamental forms has no directions.
fn angle_to_principal(along: Vec3<f64>, ends: [Option<Curvature>; 2]) -> Option<f64> {
    let [Some(a), Some(b)] = ends else { return None };
    // Faces that turn the other way have the other normal, and curvatures of the other sign.
    let same = if a.normal.dot(b.normal) < 0.0 { -1.0 } else { 1.0 };
    let (_, normal) = (a.normal + b.normal * same).length_and_direction();
    let normal = normal?;
    let length = along.length();
    let (_, e) = (along - normal * normal.dot(along)).length_and_direction();
    let e = e?;
    let f = normal.cross(e);
    let form = |p, q| 0.5 * (a.form(p, q) + same * b.form(p, q));
    let (ee, ef, ff) = (form(e, e), form(e, f), form(f, f));
    let (mean, half) = (0.5 * (ee + ff), 0.5 * (ee - ff));
    let radius = (half * half + ef * ef).sqrt();
    let (first, second) = (mean + radius, mean - radius);
    let size = first.abs() + second.abs();
    if 2.0 * radius < UMBILIC * size || size * length < FLAT {
        return None;
    }
    Some(0.5 * angle(half.abs(), ef.abs()).to_degrees())
}
