//! Conformal parametrisation (paper section 4.3, Eq. 14): a flat map of a polygon mesh, with a free
//! boundary, whose polygons stay as similar to the original ones as possible.
//!
//! In the plane a point is a complex number, and the polygons similar to the centred rest polygon
//! `z` are the multiples of `z`. The linear projection of section 3.2 is therefore
//! `P u = z (z* u) / |z|^2`. With `N u` centred, Eq. 14 is the quadratic form
//! `phi(u) = sum_i w_i (|N_i u_i|^2 - |z_i* u_i|^2 / |z_i|^2)`. The map is its smallest eigenvector
//! besides the constants.

mod face;
mod subspace;

pub use face::ConformalWeights;

use super::assemble::Terms;
use super::clock;
use super::error::SolveError;
use super::system::System;
use crate::math::marked;
use crate::mesh::{
    MapErrors, Mesh, ProblemKind, Topology, components, elements_with_problem, quasi_conformal,
};
use face::Face;
use nalgebra::{Complex, DMatrix};
use serde::Serialize;
use subspace::{VECTORS, smallest};

/// The norm `u* B u` that is fixed to one, without which the map would shrink to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum ConformalNorm {
    /// The sum of squares over the boundary vertices is one. A part without a boundary uses all its
    /// vertices.
    #[default]
    Boundary,
    /// The sum of squares over all vertices is one.
    Vertices,
}

/// A flat map.
#[derive(Clone, Debug, PartialEq)]
pub struct Parametrization {
    /// `#V by 2`. Every part has the same area as on the surface, and its longest axis along the
    /// first coordinate; the parts are side by side, starting at the origin. Vertices without faces
    /// that count are at the origin.
    pub uv: Vec<[f64; 2]>,
    /// The smallest nonzero eigenvalue, of the part with the greatest area.
    pub eigenvalue: f64,
    /// Number of parts that the faces connect.
    pub parts: usize,
    /// Faces that are ignored, ascending: those without an area, which have no shape to keep, and
    /// those on the same vertices as an earlier face, which would prevent both from keeping a
    /// shape.
    pub left_out: Vec<u32>,
    /// Number of parts without a boundary.
    pub closed_parts: usize,
    /// The quasi-conformal error, also of each face, and the triangles that the map flips.
    pub errors: MapErrors,
    /// Times in seconds.
    pub seconds: ConformalSeconds,
}

/// Times of a parametrisation in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ConformalSeconds {
    /// Terms and values of the matrix.
    pub assemble: f64,
    /// Fill-reducing order and symbolic analysis.
    pub order: f64,
    /// The numeric factor.
    pub factor: f64,
    /// Inverse iteration for the eigenvector.
    pub iterate: f64,
}

/// Shift of the diagonal at the vertices that the norm counts, as a fraction of the mean diagonal.
/// It makes the matrix positive definite, and is small against all eigenvalues but zero.
const SHIFT: f64 = 1e-10;

/// A map with a greater mean error has collapsed the surface to a line or a point.
const COLLAPSED: f64 = 1e6;

/// The gap between parts, as a fraction of their mean width.
const GAP: f64 = 0.05;

impl Parametrization {
    /// Maps `mesh`, part by part.
    ///
    /// # Errors
    /// If no face has an area, if a part has so little that its matrix is singular, or if a surface
    /// with a boundary has only maps that collapse.
    pub fn new(
        mesh: &Mesh,
        topology: &Topology,
        weights: ConformalWeights,
        norm: ConformalNorm,
    ) -> Result<Parametrization, SolveError> {
        let mut result = Parametrization {
            uv: vec![[0.0; 2]; mesh.positions.len()],
            eigenvalue: 0.0,
            parts: 0,
            left_out: Vec::new(),
            closed_parts: 0,
            errors: MapErrors::default(),
            seconds: ConformalSeconds::default(),
        };
        let faces = faces_that_count(mesh);
        result.left_out =
            (0..).zip(&faces).filter(|(_, face)| face.is_none()).map(|(index, _)| index).collect();
        if let Some(&first) = result.left_out.first()
            && result.left_out.len() == faces.len()
        {
            return Err(SolveError::NoArea { vertex: mesh.faces.row(first as usize)[0] });
        }
        let on_boundary = if result.left_out.is_empty() {
            boundary(topology)
        } else {
            let mut counting = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
            let all = mesh.faces.iter().zip(&faces);
            counting.faces = all.filter(|(_, face)| face.is_some()).map(|(face, _)| face).collect();
            boundary(&Topology::new(&counting))
        };
        let (mut greatest, mut edge) = (0.0, 0.0);
        for part in parts(mesh, faces) {
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
        result.errors = quasi_conformal(&mesh.positions, &result.uv, &mesh.faces, &result.left_out);
        // A closed part cannot be flattened without folds, so any error is accepted.
        let mean = result.errors.quasi_conformal.mean;
        if result.closed_parts == 0 && (mean.is_nan() || mean > COLLAPSED) {
            return Err(SolveError::Collapsed);
        }
        Ok(result)
    }
}

/// `#V`: whether the vertex is on the boundary.
fn boundary(topology: &Topology) -> Vec<bool> {
    marked(topology.neighbours().len(), topology.boundary_loops().indices())
}

/// A connected part of a mesh, with vertex numbers of its own.
struct Part {
    /// The mesh vertex of each vertex of the part.
    vertices: Vec<u32>,
    faces: Vec<Face>,
}

/// Returns the shape of each face of `mesh` (`#F`), or `None` if it is ignored: see
/// [`Parametrization::left_out`].
fn faces_that_count(mesh: &Mesh) -> Vec<Option<Face>> {
    let diameter = mesh.size();
    let faces = mesh.faces.iter().map(|face| Face::new(face, &mesh.positions, diameter));
    let mut faces: Vec<Option<Face>> = faces.collect();
    for repeated in elements_with_problem(mesh, ProblemKind::DuplicateFace).faces {
        faces[repeated as usize] = None;
    }
    faces
}

/// Returns the parts that these faces connect, ordered by their smallest vertices.
fn parts(mesh: &Mesh, faces: Vec<Option<Face>>) -> Vec<Part> {
    let with_area = mesh.faces.iter().zip(&faces).filter(|(_, face)| face.is_some());
    let labels = components(mesh.positions.len(), with_area.map(|(corners, _)| corners));
    let count = labels.iter().max().map_or(0, |&last| last as usize + 1);
    let mut parts: Vec<Part> =
        (0..count).map(|_| Part { vertices: Vec::new(), faces: Vec::new() }).collect();
    let mut own = Vec::with_capacity(labels.len());
    for (v, &label) in (0..).zip(&labels) {
        own.push(parts[label as usize].vertices.len() as u32);
        parts[label as usize].vertices.push(v);
    }
    for (corners, face) in mesh.faces.iter().zip(faces) {
        let Some(mut face) = face else { continue };
        face.corners = corners.iter().map(|&v| own[v as usize]).collect();
        parts[labels[corners[0] as usize] as usize].faces.push(face);
    }
    parts.retain(|part| !part.faces.is_empty());
    parts
}

impl Part {
    /// Returns the map of least energy, `#vertices by 2`, and its eigenvalue. `counts` marks the
    /// vertices that the norm counts.
    fn map(
        &self,
        weights: ConformalWeights,
        counts: &[bool],
        seconds: &mut ConformalSeconds,
    ) -> Result<(Vec<[f64; 2]>, f64), SolveError> {
        let started = clock::now();
        let singular = || SolveError::NoArea { vertex: self.vertices[0] };
        // Complex unknowns: the vertices, and the extra ones of faces with many corners.
        let mut unknowns = self.vertices.len();
        let mut terms = Terms::default();
        let (mut diagonal, mut degrees) = (0.0, 0.0);
        for face in &self.faces {
            let weight = face.weight(weights);
            if !weight.is_finite() {
                return Err(singular());
            }
            face.push_terms(&mut terms, weight, unknowns as u32);
            unknowns += face.extra_unknowns();
            diagonal += weight * face.corners.len() as f64;
            degrees += face.corners.len() as f64;
        }
        let n = 2 * unknowns;
        seconds.assemble += clock::now() - started;
        let sizes = [n, 2 * self.vertices.len()];
        let mut system = System::with_order(sizes, vec![terms], Default::default(), None);
        let shift = SHIFT * diagonal / degrees.max(1.0);
        let node_of = system.node_of();
        let nodes: Vec<[u32; 2]> =
            (0..unknowns).map(|k| [node_of[2 * k], node_of[2 * k + 1]]).collect();
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
        let start = DMatrix::from_fn(counted.len(), VECTORS, |k, j| start(counted[k] as usize, j));
        let mut map = smallest(&mut system, &nodes, &counted, start).ok_or_else(singular)?;
        map.truncate(self.vertices.len());
        let energies = self.faces.iter().map(|face| face.weight(weights) * face.distance(&map));
        let energy: f64 = energies.sum();
        seconds.iterate += clock::now() - iterating;
        Ok((map, energy))
    }

    /// Returns the map scaled to the area of the surface, with its longest axis along the first
    /// coordinate and its least coordinates zero; also that area and the extents.
    fn laid_out(&self, mut map: Vec<[f64; 2]>) -> (Vec<[f64; 2]>, f64, [f64; 2]) {
        let n = map.len() as f64;
        let mut mean = [0.0; 2];
        map.iter().for_each(|[x, y]| mean = [mean[0] + x / n, mean[1] + y / n]);
        // The square root of the sum of squares, as complex numbers, points along the longest axis.
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
        // Signed, the areas of a closed surface would add up to zero.
        let flat_area: f64 = self.faces.iter().map(|face| face.area_in(&map).abs()).sum();
        let scale = if flat_area != 0.0 { (area / flat_area).sqrt() } else { 1.0 };
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

/// The settings of a map that flips fewer faces.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FewerFlips {
    /// The weights of the faces.
    pub weights: ConformalWeights,
    /// The norm that is fixed.
    pub norm: ConformalNorm,
    /// Number of faces that this map flips.
    pub flipped: usize,
    /// Its mean quasi-conformal error.
    pub mean: f64,
}

impl FewerFlips {
    /// Returns the settings that flip the fewest faces, if these are fewer than `flipped`; of
    /// several, those with the least mean error. Computes the maps of all settings.
    pub fn of(mesh: &Mesh, topology: &Topology, flipped: usize) -> Option<FewerFlips> {
        let mut best: Option<FewerFlips> = None;
        for weights in
            [ConformalWeights::InverseArea, ConformalWeights::One, ConformalWeights::Lscm]
        {
            for norm in [ConformalNorm::Boundary, ConformalNorm::Vertices] {
                let Ok(map) = Parametrization::new(mesh, topology, weights, norm) else { continue };
                let errors = map.errors;
                let mean = errors.quasi_conformal.mean;
                let found = FewerFlips { weights, norm, flipped: errors.flipped, mean };
                let is_better =
                    |best: FewerFlips| (found.flipped, found.mean) < (best.flipped, best.mean);
                if found.flipped < flipped && best.is_none_or(is_better) {
                    best = Some(found);
                }
            }
        }
        best
    }
}

/// Start vector `j` at one vertex, scattered so that it has a component along every eigenvector.
fn start(vertex: usize, j: usize) -> Complex<f64> {
    // In 64 bits also where addresses have 32.
    let scattered =
        |k: usize| ((vertex as u64 * 7919 + k as u64 * 104_729) % 1009) as f64 / 1009.0 - 0.5;
    Complex::new(scattered(j), scattered(VECTORS + j))
}
