//! Measures of the result: irregular vertices, angles to the lines of curvature, edge lengths.

use super::distance::LargestDistances;
use super::samples::Samples;
use crate::math::{Vec3, angle, angle_between, argsort, key_of_number};
use crate::mesh::form_on;
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;

/// Numbers of irregular vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Irregular {
    /// Inner vertices of other than four edges.
    pub inside: usize,
    /// Boundary vertices with another number of panels than the angle of the boundary asks for; none
    /// of a boundary that cuts its panels.
    pub boundary: usize,
}

/// Angles of edges to the nearest principal direction of the input, in degrees, weighted by the
/// difference of the principal curvatures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AngleToCurvature {
    /// The mean.
    pub mean: f64,
    /// The angle that a tenth of the weight exceeds.
    pub p90: f64,
}

/// Lengths of edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EdgeLengths {
    /// In the unit of the mesh.
    pub mean: f64,
    /// Standard deviation divided by the mean.
    pub cv: f64,
}

/// The measures of a result.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct RemeshMeasures {
    /// Number of quads.
    pub quads: usize,
    /// Number of other faces.
    pub other_faces: usize,
    /// Irregular vertices.
    pub irregular: Irregular,
    /// Angles of the edges to the lines of curvature; none where the surface has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<AngleToCurvature>,
    /// Lengths of edges.
    pub edge: EdgeLengths,
    /// Distances to the input and from it.
    pub distance: LargestDistances,
    /// Number of boundary loops.
    pub loops: usize,
    /// Vertices minus edges plus faces.
    pub euler: i64,
}

/// Panels count as curved if the surface turns from one end to the other by more than this, in
/// radians, in one principal direction than in the other.
const CURVED: f64 = 0.05;
/// A boundary vertex is irregular if its angle differs by more than this from the number of its
/// panels, in right angles.
const MOST_TURNED: f64 = 0.75;

/// What is counted in each part of the surface.
#[derive(Clone, Debug, Default)]
pub(in crate::quads) struct Tally {
    quads: usize,
    other_faces: usize,
    irregular: Irregular,
    /// The irregular vertices, in the order of all vertices of all parts.
    pub(in crate::quads) irregular_vertices: Vec<u32>,
    /// Number of vertices of the parts.
    vertices: usize,
    /// Angle in degrees and weight.
    angles: Vec<[f64; 2]>,
    lengths: Vec<f64>,
}

impl Tally {
    /// Counts the faces of one part, with corners at `positions`; those of `samples` describe the
    /// surface there. `size` is the side of a panel; `cuts` says whether the boundary cuts panels.
    pub(in crate::quads) fn add(
        &mut self,
        positions: &[Vec3<f64>],
        faces: &[Vec<usize>],
        samples: &Samples,
        size: f64,
        cuts: bool,
    ) {
        self.quads += faces.iter().filter(|face| face.len() == 4).count();
        self.other_faces += faces.iter().filter(|face| face.len() != 4).count();
        let mut edges: Vec<[usize; 2]> = Vec::new();
        let mut turns = vec![0.0; positions.len()];
        let mut panels = vec![0.0; positions.len()];
        for face in faces {
            let count = face.len();
            for k in 0..count {
                let (a, b) = (face[k], face[(k + 1) % count]);
                edges.push([a.min(b), a.max(b)]);
                let [next, last] =
                    [b, face[(k + count - 1) % count]].map(|v| positions[v] - positions[a]);
                turns[a] += angle_between(next, last).map_or(1.0, |corner| corner / FRAC_PI_2);
                panels[a] += 1.0;
            }
        }
        edges.sort_unstable();
        let mut valence = vec![0; positions.len()];
        let mut boundary = vec![false; positions.len()];
        for same in edges.chunk_by(|x, y| x == y) {
            let [a, b] = same[0];
            for v in [a, b] {
                valence[v] += 1;
                boundary[v] |= same.len() == 1;
            }
            let along = positions[b] - positions[a];
            self.lengths.push(along.length());
            self.angles.extend(angle_to_curvature(along, [a, b], samples, size));
        }
        for v in (0..positions.len()).filter(|&v| valence[v] > 0) {
            let (is_irregular, count) = if boundary[v] {
                let difference: f64 = turns[v] - panels[v];
                (!cuts && difference.abs() > MOST_TURNED, &mut self.irregular.boundary)
            } else {
                (valence[v] != 4, &mut self.irregular.inside)
            };
            if is_irregular {
                *count += 1;
                self.irregular_vertices.push((self.vertices + v) as u32);
            }
        }
        self.vertices += positions.len();
    }

    /// The measures of all parts together.
    pub(in crate::quads) fn measures(
        mut self,
        distance: LargestDistances,
        loops: usize,
        euler: i64,
    ) -> RemeshMeasures {
        let order = argsort(self.angles.iter().map(|pair| key_of_number(pair[0])));
        self.angles = order.into_iter().map(|k| self.angles[k as usize]).collect();
        let weight: f64 = self.angles.iter().map(|pair| pair[1]).sum();
        let angle = (weight > 0.0).then(|| {
            let sum: f64 = self.angles.iter().map(|[angle, weight]| angle * weight).sum();
            let mut below = 0.0;
            let p90 = self.angles.iter().find(|pair| {
                below += pair[1];
                below >= 0.9 * weight
            });
            AngleToCurvature { mean: sum / weight, p90: p90.map_or(0.0, |pair| pair[0]) }
        });
        let count = self.lengths.len().max(1) as f64;
        let mean = self.lengths.iter().sum::<f64>() / count;
        let squares = self.lengths.iter().map(|length| (length - mean) * (length - mean));
        let deviation = (squares.sum::<f64>() / count).sqrt();
        let cv = if mean > 0.0 { deviation / mean } else { 0.0 };
        RemeshMeasures {
            quads: self.quads,
            other_faces: self.other_faces,
            irregular: self.irregular,
            angle,
            edge: EdgeLengths { mean, cv },
            distance,
            loops,
            euler,
        }
    }
}

/// The angle of an edge to the nearest principal direction in degrees, and its weight; none where
/// the surface is about flat or spherical.
fn angle_to_curvature(
    along: Vec3<f64>,
    ends: [usize; 2],
    samples: &Samples,
    size: f64,
) -> Option<[f64; 2]> {
    let [a, b] = ends;
    let normal = (samples.normals[a] + samples.normals[b]).direction_or_zero();
    let e = (along - normal * normal.dot(along)).direction_or_zero();
    let f = normal.cross(e);
    let form = |p: Vec3<f64>, q: Vec3<f64>| {
        0.5 * (form_on(&samples.tensors[a], p, q) + form_on(&samples.tensors[b], p, q))
    };
    // The difference of the curvatures times cosine and sine of twice the angle.
    let (cosine, sine) = (form(e, e) - form(f, f), 2.0 * form(e, f));
    let difference = (cosine * cosine + sine * sine).sqrt();
    let doubled = angle(cosine.abs(), sine.abs())?;
    (difference * size > CURVED).then(|| [(0.5 * doubled).to_degrees(), difference])
}
