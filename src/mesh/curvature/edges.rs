//! Angles between the edges of a mesh and the lines of curvature of its surface.
//!
//! The edges of quads with circumcircles converge to the lines of curvature as the quads become
//! small (Bobenko and Suris 2008, Liu et al. 2006). Where the edges deviate from them, the mesh has
//! to rotate them to become circular.

use super::{Curvature, SecondForm, curvatures, form_on};
use crate::math::{Vec3, angle, polygon_sides};
use crate::mesh::{Point, Ragged, Topology};

/// Principal curvatures count as equal, up to the error of the fit, if their difference is at most
/// this fraction of the sum of their absolute values.
pub(super) const UMBILIC: f64 = 0.2;

/// Alignment of the edges of faces with the principal directions of the surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurvatureLines {
    /// Angle of each edge of [`Topology::edges`] to the nearest principal direction, in degrees
    /// from 0 to 45; NaN where the surface has none (flat or spherical) or it is unknown.
    pub angles: Vec<f64>,
    /// Mean of the angles, weighted by edge length; `None` if no edge has an angle.
    pub mean: Option<f64>,
    /// Fraction of the total length of the edges that has an angle.
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

    /// Returns the mean angle of the sides of each face, `#F`, in degrees from 0 to 45; NaN if no
    /// side has one.
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

/// Returns the angle in degrees; `None` if the mean of the second fundamental forms at the ends has
/// no principal directions.
fn angle_to_principal(along: Vec3<f64>, ends: [Option<Curvature>; 2]) -> Option<f64> {
    let [Some(a), Some(b)] = ends else { return None };
    // Faces of opposite orientation have the opposite normal, and curvatures of opposite sign.
    let same = if a.normal.dot(b.normal) < 0.0 { -1.0 } else { 1.0 };
    let (_, normal) = (a.normal + b.normal * same).length_and_direction();
    let normal = normal?;
    let (_, e) = (along - normal * normal.dot(along)).length_and_direction();
    let e = e?;
    let f = normal.cross(e);
    let [of_a, of_b] = [a, b].map(|end| end.tensor());
    let form = |p, q| 0.5 * (form_on(&of_a, p, q) + same * form_on(&of_b, p, q));
    let (ee, ef, ff) = (form(e, e), form(e, f), form(f, f));
    let curvature = Curvature::of(SecondForm { axes: [e, f], values: [ee, ef, ff] });
    if !curvature.has_directions(UMBILIC, along.length()) {
        return None;
    }
    angle(0.5 * (ee - ff).abs(), ef.abs()).map(|twice| 0.5 * twice.to_degrees())
}
