//! Conformal parametrisation (paper section 4.3, Eq. 14): a flat map of a polygon mesh whose polygons
//! stay as similar to themselves as they can, with a free boundary.
//!
//! In the plane a point is a complex number, and the polygons similar to the centred rest polygon `z`
//! are the multiples of `z`. So the linear projection of section 3.2 is `P u = z (z* u) / |z|^2`, and
//! with `N u` centred Eq. 14 is `phi(u) = sum_i w_i (|N_i u_i|^2 - |z_i* u_i|^2 / |z_i|^2)`: a quadratic
//! form. Its smallest eigenvector beside the constants is the map.

use super::assemble::Terms;
use super::subspace::{Pair, smallest};
use super::{SolveError, System, clock};
use crate::math::{PrincipalAxes, Vec3, centre};
use crate::mesh::{MapErrors, Mesh, Point, Topology, components, quasi_conformal};
use crate::scene::Worded;
use serde::Serialize;

/// The weights `w_i` of Eq. 14.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConformalWeights {
    /// The inverse of the area of the polygon, so that the map does not depend on the meshing.
    #[default]
    InverseArea,
    /// One.
    One,
    /// `|z|^2 / area`: on triangles the map of least-squares conformal maps.
    Lscm,
}

/// What is kept from shrinking to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConformalNorm {
    /// The boundary: the sum of squares over its vertices is one. A part without a boundary takes all its
    /// vertices.
    #[default]
    Boundary,
    /// The sum of squares over all vertices is one.
    Vertices,
}

impl Worded for ConformalWeights {
    const WORDS: &'static [(&'static str, ConformalWeights)] = &[
        ("inverse-area", ConformalWeights::InverseArea),
        ("one", ConformalWeights::One),
        ("lscm", ConformalWeights::Lscm),
    ];
}

impl Worded for ConformalNorm {
    const WORDS: &'static [(&'static str, ConformalNorm)] =
        &[("boundary", ConformalNorm::Boundary), ("vertices", ConformalNorm::Vertices)];
}

/// A flat map.
#[derive(Clone, Debug, PartialEq)]
pub struct Parametrization {
    /// `#V by 2`. Every part has the area that it has on the surface, its longest axis along the first
    /// coordinate; the parts lie side by side from the origin on. Vertices without faces are at the
    /// origin.
    pub uv: Vec<[f64; 2]>,
    /// The smallest eigenvalue beside zero, of the part with the greatest area.
    pub eigenvalue: f64,
    /// The connected parts that have faces.
    pub parts: usize,
    /// Parts without a boundary.
    pub closed_parts: usize,
    /// The quasi-conformal error, of each face too, and the triangles that the map turns over.
    pub errors: MapErrors,
    /// What it took.
    pub seconds: ConformalSeconds,
}

/// Seconds that a parametrisation took, by part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ConformalSeconds {
    /// The matrix.
    pub assemble: f64,
    /// The order of elimination.
    pub order: f64,
    /// The factorisation.
    pub factor: f64,
    /// The eigenvector.
    pub iterate: f64,
}

/// The metric of vertices that the norm does not count is shifted by this fraction of the mean
/// diagonal, so that the matrix is positive definite; small against all eigenvalues but zero.
const SHIFT: f64 = 1e-10;

/// The gap between parts, as a fraction of their mean width.
const GAP: f64 = 0.05;

impl Parametrization {
    /// Maps `mesh`, part by part.
    ///
    /// # Errors
    /// When a part has no area, or so little that its matrix is singular.
    pub fn new(
        mesh: &Mesh,
        topology: &Topology,
        weights: ConformalWeights,
        norm: ConformalNorm,
    ) -> Result<Parametrization, SolveError> {
        let mut on_boundary = vec![false; mesh.positions.len()];
        for loop_ in topology.boundary_loops().iter() {
            loop_.iter().for_each(|&v| on_boundary[v as usize] = true);
        }
        let mut result = Parametrization {
            uv: vec![[0.0; 2]; mesh.positions.len()],
            eigenvalue: 0.0,
            parts: 0,
            closed_parts: 0,
            errors: MapErrors::default(),
            seconds: ConformalSeconds::default(),
        };
        let (mut greatest, mut edge) = (0.0, 0.0);
        for part in parts(mesh) {
            let is_closed = !part.vertices.iter().any(|&v| on_boundary[v as usize]);
            let counts: Vec<bool> = part
                .vertices
                .iter()
                .map(|&v| norm == ConformalNorm::Vertices || is_closed || on_boundary[v as usize])
                .collect();
            let (map, eigenvalue) = part.map(weights, &counts, &mut result.seconds)?;
            let (map, area, [width, _]) = part.laid_out(map);
            for (&v, &[x, y]) in part.vertices.iter().zip(&map) {
                result.uv[v as usize] = [x + edge, y];
            }
            edge += width * (1.0 + GAP);
            if area > greatest {
                (greatest, result.eigenvalue) = (area, eigenvalue);
            }
            result.parts += 1;
            result.closed_parts += usize::from(is_closed);
        }
        result.errors = quasi_conformal(&mesh.positions, &result.uv, &mesh.faces);
        Ok(result)
    }
}

/// A connected part of a mesh with numbers of its own.
struct Part {
    /// The vertex of the mesh of each of its own.
    vertices: Vec<u32>,
    faces: Vec<Face>,
}

/// A face in its own plane.
struct Face {
    /// Corners, in the numbers of the part.
    corners: Vec<u32>,
    /// The corners in the least-squares plane, centred, the face's own turn counterclockwise.
    flat: Vec<[f64; 2]>,
    area: f64,
    /// `|z|^2`.
    squares: f64,
}

/// The connected parts that have faces, in the order of their smallest vertices.
fn parts(mesh: &Mesh) -> Vec<Part> {
    let labels = components(mesh.positions.len(), mesh.faces.iter());
    let count = labels.iter().max().map_or(0, |&last| last as usize + 1);
    let mut parts: Vec<Part> =
        (0..count).map(|_| Part { vertices: Vec::new(), faces: Vec::new() }).collect();
    let mut own = Vec::with_capacity(labels.len());
    for (v, &label) in (0..).zip(&labels) {
        own.push(parts[label as usize].vertices.len() as u32);
        parts[label as usize].vertices.push(v);
    }
    for face in mesh.faces.iter() {
        let corners = face.iter().map(|&v| own[v as usize]).collect();
        let part = &mut parts[labels[face[0] as usize] as usize];
        part.faces.push(Face::new(corners, face, &mesh.positions));
    }
    parts.retain(|part| !part.faces.is_empty());
    parts
}

impl Face {
    fn new(corners: Vec<u32>, vertices: &[u32], positions: &[Point]) -> Face {
        let mut points: Vec<Vec3<f64>> =
            vertices.iter().map(|&v| positions[v as usize].into()).collect();
        centre(&mut points);
        let mut flat = match points[..] {
            [a, b, c] => flat_triangle(a, b, c),
            _ => flat_polygon(points),
        };
        let n = flat.len();
        let cross = |k: usize| {
            let ([a, b], [c, d]) = (flat[k], flat[(k + 1) % n]);
            a * d - b * c
        };
        let area = 0.5 * (0..n).map(cross).sum::<f64>();
        if area < 0.0 {
            // The axes are of either handedness.
            flat.iter_mut().for_each(|[_, y]| *y = -*y);
        }
        let squares = flat.iter().map(|[x, y]| x * x + y * y).sum();
        Face { corners, flat, area: area.abs(), squares }
    }

    fn weight(&self, weights: ConformalWeights) -> f64 {
        match weights {
            ConformalWeights::InverseArea => 1.0 / self.area,
            ConformalWeights::One => 1.0,
            ConformalWeights::Lscm => self.squares / self.area,
        }
    }

    /// `|N u - P u|^2` at the map `u`.
    fn distance(&self, u: &[[f64; 2]]) -> f64 {
        let n = self.corners.len() as f64;
        let mut mean = [0.0; 2];
        for &v in &self.corners {
            mean = [mean[0] + u[v as usize][0] / n, mean[1] + u[v as usize][1] / n];
        }
        let own =
            || self.corners.iter().map(|&v| u[v as usize]).map(|[x, y]| [x - mean[0], y - mean[1]]);
        // z* u / |z|^2, the factor of the closest multiple of z.
        let (mut real, mut imaginary) = (0.0, 0.0);
        for ([x, y], [a, b]) in own().zip(&self.flat) {
            real += (a * x + b * y) / self.squares;
            imaginary += (a * y - b * x) / self.squares;
        }
        own()
            .zip(&self.flat)
            .map(|([x, y], [a, b])| {
                let (dx, dy) = (x - (real * a - imaginary * b), y - (real * b + imaginary * a));
                dx * dx + dy * dy
            })
            .sum()
    }
}

impl Part {
    /// The map of least energy, `#vertices by 2`, and its eigenvalue. `counts` tells of each vertex whether
    /// the norm counts it.
    fn map(
        &self,
        weights: ConformalWeights,
        counts: &[bool],
        seconds: &mut ConformalSeconds,
    ) -> Result<(Vec<[f64; 2]>, f64), SolveError> {
        let started = clock::now();
        let singular = || SolveError::NoArea { vertex: self.vertices[0] };
        // A face without area has no shape to keep.
        let faces = || self.faces.iter().filter(|face| face.area > 0.0);
        let n = 2 * self.vertices.len();
        let mut terms = Terms::default();
        let (mut diagonal, mut degrees) = (0.0, 0.0);
        for face in faces() {
            let weight = face.weight(weights);
            if !weight.is_finite() {
                return Err(singular());
            }
            push_terms(&mut terms, face, weight);
            diagonal += weight * face.corners.len() as f64;
            degrees += face.corners.len() as f64;
        }
        seconds.assemble += clock::now() - started;
        let mut system = System::new(n, vec![terms]);
        let shift = SHIFT * diagonal / degrees.max(1.0);
        let node_of = system.node_of();
        let nodes: Vec<[u32; 2]> =
            (0..self.vertices.len()).map(|v| [node_of[2 * v], node_of[2 * v + 1]]).collect();
        let counted: Vec<u32> = (0..).zip(counts).filter(|(_, c)| **c).map(|(v, _)| v).collect();
        let mut shifts = vec![0.0; n];
        for &v in &counted {
            for node in nodes[v as usize] {
                shifts[node as usize] = shift;
            }
        }
        system.factor(&[1.0], &shifts, vec![false; n]).map_err(|error| match error {
            SolveError::NotPositiveDefinite { vertex } => {
                SolveError::NoArea { vertex: self.vertices[vertex as usize / 2] }
            }
            other => other,
        })?;
        seconds.assemble += system.seconds.assemble;
        seconds.order += system.seconds.order;
        seconds.factor += system.seconds.factor;

        let iterating = clock::now();
        let start = counted.iter().map(|&v| start(v as usize)).collect();
        let map = smallest(&mut system, &nodes, &counted, start).ok_or_else(singular)?;
        let energy: f64 = faces().map(|face| face.weight(weights) * face.distance(&map)).sum();
        seconds.iterate += clock::now() - iterating;
        Ok((map, energy))
    }

    /// The map with the area of the surface, its longest axis along the first coordinate and its least
    /// coordinates zero; with that area and the extents.
    fn laid_out(&self, mut map: Vec<[f64; 2]>) -> (Vec<[f64; 2]>, f64, [f64; 2]) {
        let n = map.len() as f64;
        let mut mean = [0.0; 2];
        map.iter().for_each(|[x, y]| mean = [mean[0] + x / n, mean[1] + y / n]);
        // The square root of the sum of squares of complex numbers points along the longest axis.
        let (mut real, mut imaginary) = (0.0, 0.0);
        for p in &mut map {
            *p = [p[0] - mean[0], p[1] - mean[1]];
            real += p[0] * p[0] - p[1] * p[1];
            imaginary += 2.0 * p[0] * p[1];
        }
        let length = (real * real + imaginary * imaginary).sqrt();
        let [cosine, sine] = if length > 0.0 {
            let cosine = (0.5 * (1.0 + real / length)).max(0.0).sqrt();
            let sine = (0.5 * (1.0 - real / length)).max(0.0).sqrt();
            [cosine, if imaginary < 0.0 { -sine } else { sine }]
        } else {
            [1.0, 0.0]
        };
        let area: f64 = self.faces.iter().map(|face| face.area).sum();
        let flat_area: f64 = self.faces.iter().map(|face| face.area_in(&map)).sum();
        let scale = if flat_area != 0.0 { (area / flat_area.abs()).sqrt() } else { 1.0 };
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in &mut map {
            let [x, y] = *p;
            *p = [scale * (cosine * x + sine * y), scale * (cosine * y - sine * x)];
            for i in 0..2 {
                (low[i], high[i]) = (low[i].min(p[i]), high[i].max(p[i]));
            }
        }
        map.iter_mut().for_each(|[x, y]| (*x, *y) = (*x - low[0], *y - low[1]));
        (map, area, [high[0] - low[0], high[1] - low[1]])
    }
}

/// Centred points in their least-squares plane.
fn flat_polygon(mut points: Vec<Vec3<f64>>) -> Vec<[f64; 2]> {
    let scale = PrincipalAxes::rotate(&mut points).scale;
    points.iter().map(|p| [p.x * scale, p.y * scale]).collect()
}

/// A centred triangle in its own plane, with its first side along the first axis.
fn flat_triangle(a: Vec3<f64>, b: Vec3<f64>, c: Vec3<f64>) -> Vec<[f64; 2]> {
    let (along, across) = (b - a, c - a);
    let base = along.length();
    if base == 0.0 {
        return vec![[0.0; 2]; 3];
    }
    let (foot, height) = (along.dot(across) / base, along.cross(across).length() / base);
    let (x, y) = ((base + foot) / 3.0, height / 3.0);
    vec![[-x, -y], [base - x, -y], [foot - x, height - y]]
}

/// Vectors to begin with, at one vertex: what is in no way special has some of every eigenvector.
fn start(vertex: usize) -> Pair {
    let scattered = |k: usize| ((vertex * 7919 + k * 104_729) % 1009) as f64 / 1009.0 - 0.5;
    [0, 4].map(|first| std::array::from_fn(|k| scattered(first + k)))
}

impl Face {
    /// The signed area in the map.
    fn area_in(&self, map: &[[f64; 2]]) -> f64 {
        let n = self.corners.len();
        let at = |k: usize| map[self.corners[k % n] as usize];
        let crosses = (0..n).map(|k| at(k)[0] * at(k + 1)[1] - at(k)[1] * at(k + 1)[0]);
        0.5 * crosses.sum::<f64>()
    }
}

/// Adds `w (|N u|^2 - |z* u|^2 / |z|^2)`, where vertex `v` has the unknowns `2 v` and `2 v + 1`.
fn push_terms(terms: &mut Terms, face: &Face, weight: f64) {
    let nodes: Vec<u32> = face.corners.iter().flat_map(|&v| [2 * v, 2 * v + 1]).collect();
    let n = face.corners.len();
    let flat = || face.flat.iter();
    if n == 3 {
        // Beside the constants and the multiples of z there is one direction left, so that the energy is
        // the square of one complex number: the sum of the u, each times the side opposite to it.
        let opposite = || {
            (0..3).map(|k| {
                let ([a, b], [c, d]) = (face.flat[(k + 1) % 3], face.flat[(k + 2) % 3]);
                [c - a, d - b]
            })
        };
        let outer = weight / (3.0 * face.squares);
        terms.push(&nodes, opposite().flat_map(|[a, b]| [a, -b]), 0.0, outer);
        terms.push(&nodes, opposite().flat_map(|[a, b]| [b, a]), 0.0, outer);
        return;
    }
    for part in 0..2 {
        let nodes: Vec<u32> = face.corners.iter().map(|&v| 2 * v + part).collect();
        terms.push(&nodes, flat().map(|_| 1.0), weight, -weight / n as f64);
    }
    // The real and the imaginary part of z* u.
    let outer = -weight / face.squares;
    terms.push(&nodes, flat().flat_map(|&[a, b]| [a, b]), 0.0, outer);
    terms.push(&nodes, flat().flat_map(|&[a, b]| [-b, a]), 0.0, outer);
}
