//! Subdivision of polygon meshes, smooth or linear.
//!
//! Catmull and Clark 1978 for polygons, Loop 1987 with the weights of Warren 1995 for triangles.
//! Sharp edges and the boundary become cubic B-splines, corners stay fixed (Hoppe et al. 1994).

use super::origins::{Combinations, Edited, Origins, Sum};
use super::sharp::Sharp;
use crate::math::{polygon_corners, visits_twice};
use crate::mesh::{Group, Mesh, Ragged, Topology};
use crate::words;
use std::fmt;

/// Maximum number of levels at once.
const MOST_LEVELS: u32 = 6;
/// Maximum number of vertices of a subdivided mesh.
const MOST_VERTICES: usize = 4_000_000;

/// Maximum sum of the squared numbers of corners of large faces, where each new vertex at a face depends
/// on all of its corners: memory grows with it, to about 1 GB at this number.
const MOST_SQUARED: u64 = 20_000_000;

/// Subdivision scheme.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum Scheme {
    /// Smooth; quads from polygons.
    #[default]
    CatmullClark,
    /// Keeps the edges where they are; quads from polygons, or triangles if all faces are triangles.
    Linear,
    /// Smooth; triangles from triangles.
    Loop,
}

/// Parameters of a subdivision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subdivision {
    /// The scheme.
    pub scheme: Scheme,
    /// Number of levels, at least one.
    pub levels: u32,
    /// Angle in degrees above which creases, and corners of boundaries and creases, stay sharp.
    pub keep: f64,
}

/// Default of [`Subdivision::keep`], in degrees: outlines of hexagons become round, those of quads
/// keep their corners.
pub const KEPT_TURN: f64 = 75.0;

/// The numbers of vertices and faces that a subdivision makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SubdividedCounts {
    /// `#V`
    pub vertices: usize,
    /// `#F`
    pub faces: usize,
}

/// Reason why a mesh cannot be subdivided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SubdivideError {
    /// This number of levels is out of range.
    Levels(u32),
    /// [`Subdivision::keep`] is not an angle from 0 to 180 degrees.
    Turn,
    /// The mesh has neither faces nor curves.
    Nothing,
    /// The mesh has tetrahedra.
    Tetrahedra,
    /// Loop's scheme requires triangles; this many faces are not.
    NotTriangles(usize),
    /// This face visits a vertex twice.
    Repeated(u32),
    /// The result would have more than 4,000,000 vertices.
    TooMany,
    /// One face, or large faces together, have too many corners; the largest has this many.
    LargeFaces(usize),
}

impl fmt::Display for SubdivideError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SubdivideError::Levels(levels) => {
                write!(f, "found {levels} levels, expected 1 to {MOST_LEVELS}")
            }
            SubdivideError::Turn => {
                f.write_str("expected an angle from 0 to 180 degrees for sharp edges")
            }
            SubdivideError::Nothing => f.write_str("there are no faces and no curves to refine"),
            SubdivideError::Tetrahedra => {
                f.write_str("the mesh has tetrahedra, expected faces and curves only")
            }
            SubdivideError::NotTriangles(1) => {
                f.write_str("one face is not a triangle; Loop's scheme requires triangles")
            }
            SubdivideError::NotTriangles(faces) => {
                let faces = words::group_digits(*faces);
                write!(f, "{faces} faces are not triangles; Loop's scheme requires triangles")
            }
            SubdivideError::Repeated(face) => {
                write!(f, "face {face} has the same vertex at two corners")
            }
            SubdivideError::TooMany => {
                let most = words::group_digits(MOST_VERTICES);
                write!(f, "the result would have more than {most} vertices")
            }
            SubdivideError::LargeFaces(corners) => {
                let said = words::group_digits(*corners);
                if (*corners as u64).pow(2) > MOST_SQUARED {
                    let most = words::group_digits(MOST_SQUARED.isqrt() as usize);
                    return write!(f, "a face has {said} corners, expected at most {most}");
                }
                write!(
                    f,
                    "faces have up to {said} corners, together too many to refine: expected fewer or smaller ones"
                )
            }
        }
    }
}

impl std::error::Error for SubdivideError {}

impl Subdivision {
    /// Returns the numbers of vertices and faces of the subdivided `mesh`.
    ///
    /// # Errors
    /// If the mesh cannot be subdivided with these parameters.
    pub fn counts(
        &self,
        mesh: &Mesh,
        topology: &Topology,
    ) -> Result<SubdividedCounts, SubdivideError> {
        if !(1..=MOST_LEVELS).contains(&self.levels) {
            return Err(SubdivideError::Levels(self.levels));
        }
        if !(0.0..=180.0).contains(&self.keep) {
            return Err(SubdivideError::Turn);
        }
        if mesh.faces.is_empty() && mesh.curves.is_empty() {
            return Err(SubdivideError::Nothing);
        }
        if !mesh.tets.is_empty() {
            return Err(SubdivideError::Tetrahedra);
        }
        let others = mesh.faces.iter().filter(|face| face.len() != 3).count();
        if self.scheme == Scheme::Loop && others > 0 {
            return Err(SubdivideError::NotTriangles(others));
        }
        if let Some(face) = mesh.faces.iter().position(visits_twice) {
            return Err(SubdivideError::Repeated(face as u32));
        }
        let splits_triangles = self.splits_triangles(mesh);
        // One level of means couples no more than the ends of each edge.
        let is_coupled = !splits_triangles && (self.scheme != Scheme::Linear || self.levels > 1);
        // Smaller ones are limited by the number of vertices.
        let large = || mesh.faces.iter().map(<[u32]>::len).filter(|size| *size > 32);
        if is_coupled && large().map(|size| (size as u64).pow(2)).sum::<u64>() > MOST_SQUARED {
            return Err(SubdivideError::LargeFaces(large().max().unwrap_or(0)));
        }
        let mut vertices = mesh.positions.len();
        let mut edges = topology.edges().len();
        let (mut faces, mut corners) = (mesh.faces.len(), mesh.faces.indices().len());
        for _ in 0..self.levels {
            let (inner, children) =
                if splits_triangles { (0, 4 * faces) } else { (faces, corners) };
            (vertices, edges) = (vertices + edges + inner, 2 * edges + corners);
            (faces, corners) = (children, if splits_triangles { 3 } else { 4 } * children);
            if vertices > MOST_VERTICES {
                return Err(SubdivideError::TooMany);
            }
        }
        Ok(SubdividedCounts { vertices, faces })
    }

    /// Subdivides `mesh` with its `topology`. At each level the old vertices come first, then those
    /// on edges in the order of [`Topology::edges`], then those in faces; the children of a face
    /// are consecutive.
    ///
    /// # Errors
    /// As [`Subdivision::counts`].
    pub fn apply(&self, mesh: &Mesh, topology: &Topology) -> Result<Edited, SubdivideError> {
        self.counts(mesh, topology)?;
        let mut edited = Edited { mesh: mesh.clone(), origins: Origins::unchanged(mesh) };
        let mut sharp = Sharp::of(mesh, topology, self.keep);
        let mut own = None;
        for level in 1..=self.levels {
            let topology = own.as_ref().unwrap_or(topology);
            let next = self.once(&edited.mesh, topology, &sharp);
            let origins = edited.origins.then(&next.origins);
            if level < self.levels {
                let after = Topology::new(&next.mesh);
                let first = edited.mesh.positions.len() as u32;
                sharp = sharp.subdivided(topology, first, &after);
                own = Some(after);
            }
            edited = Edited { mesh: next.mesh, origins };
        }
        Ok(edited)
    }

    /// Whether it splits the faces of `mesh` into triangles, else into quads.
    pub fn splits_triangles(&self, mesh: &Mesh) -> bool {
        match self.scheme {
            Scheme::CatmullClark => false,
            Scheme::Linear => mesh.faces.iter().all(|face| face.len() == 3),
            Scheme::Loop => true,
        }
    }

    fn once(&self, mesh: &Mesh, topology: &Topology, sharp: &Sharp) -> Edited {
        let split = Split::new(mesh, topology, self.splits_triangles(mesh));
        let positions = match self.scheme {
            Scheme::Linear => split.positions(None, sharp),
            Scheme::CatmullClark => split.positions(Some(CATMULL_CLARK), sharp),
            Scheme::Loop => split.positions(Some(LOOP), sharp),
        };
        let (faces, parents) = split.faces();
        let mut children = vec![Vec::new(); mesh.faces.len()];
        (0..).zip(&parents).for_each(|(child, &parent)| children[parent as usize].push(child));
        let group = |group: &Group| {
            let faces = group.faces.iter().flat_map(|&face| &children[face as usize]);
            Group { faces: faces.copied().collect(), ..group.clone() }
        };
        let refined = Mesh {
            positions: positions.apply(&mesh.positions),
            faces,
            curves: mesh.curves.iter().map(|curve| split.curve(curve)).collect(),
            tets: Vec::new(),
            groups: mesh.groups.iter().map(group).collect(),
            ..Mesh::default()
        };
        let origins = Origins {
            vertices: (0..mesh.positions.len() as u32).map(Some).collect(),
            positions,
            between: split.between(),
            faces: parents.iter().map(|&parent| [parent]).collect(),
        };
        Edited { mesh: refined, origins }
    }
}

/// Weights of a scheme at smooth edges and smooth vertices.
#[derive(Clone, Copy)]
struct Weights {
    /// Of an edge vertex: weight of each end, and of each face's centre (Catmull-Clark) or third
    /// corner (Loop).
    edge: [f64; 2],
    /// Of an old vertex with `n` edges: its own weight, total of the neighbours, total of the
    /// faces.
    vertex: fn(f64) -> [f64; 3],
}

const CATMULL_CLARK: Weights =
    Weights { edge: [0.25, 0.25], vertex: |n| [(n - 2.0) / n, 1.0 / n, 1.0 / n] };
const LOOP: Weights = Weights {
    edge: [0.375, 0.125],
    vertex: |n| {
        let neighbours = if n == 3.0 { 9.0 / 16.0 } else { 3.0 / 8.0 };
        [1.0 - neighbours, neighbours, 0.0]
    },
};

/// One level: each edge gets a vertex, and so does each face unless triangles stay triangles.
struct Split<'a> {
    mesh: &'a Mesh,
    topology: &'a Topology,
    triangles: bool,
    /// Index of the first vertex on an edge, and of the first in a face.
    first: [u32; 2],
}

impl<'a> Split<'a> {
    fn new(mesh: &'a Mesh, topology: &'a Topology, triangles: bool) -> Split<'a> {
        let on_edges = mesh.positions.len() as u32;
        let first = [on_edges, on_edges + topology.edges().len() as u32];
        Split { mesh, topology, triangles, first }
    }

    fn middle(&self, [a, b]: [u32; 2]) -> u32 {
        self.first[0] + self.topology.edge(a, b).expect("every side of a face is an edge")
    }

    /// Returns the new faces, and the old face of each.
    fn faces(&self) -> (Ragged, Vec<u32>) {
        let (mut faces, mut parents) = (Ragged::new(), Vec::new());
        for (f, face) in (0..).zip(self.mesh.faces.iter()) {
            let inner = self.first[1] + f;
            let mut middles = Vec::with_capacity(face.len());
            for [before, here, after] in polygon_corners(face) {
                let sides = [[before, here], [here, after]].map(|side| self.middle(side));
                match self.triangles {
                    true => faces.push(&[here, sides[1], sides[0]]),
                    false => faces.push(&[here, sides[1], inner, sides[0]]),
                }
                middles.push(sides[1]);
            }
            if self.triangles {
                faces.push(&middles);
            }
            parents.resize(faces.len(), f);
        }
        (faces, parents)
    }

    /// Returns a curve with the vertices on its edges added.
    fn curve(&self, curve: &[u32]) -> Vec<u32> {
        let mut refined = vec![curve[0]];
        for ends in curve.windows(2) {
            // A segment from a vertex to itself has no edge.
            if ends[0] != ends[1] {
                refined.push(self.middle([ends[0], ends[1]]));
            }
            refined.push(ends[1]);
        }
        refined
    }

    /// See [`Origins::between`].
    fn between(&self) -> Ragged {
        let mut between: Ragged = (0..self.first[0]).map(|v| [v]).collect();
        self.topology.edges().iter().for_each(|ends| between.push(ends));
        if !self.triangles {
            self.mesh.faces.iter().for_each(|face| between.push(face));
            between.sort_rows();
        }
        between
    }

    /// Returns all vertices by the scheme with these weights. Without weights, old vertices stay
    /// and new ones are means.
    fn positions(&self, smooth: Option<Weights>, sharp: &Sharp) -> Combinations {
        let (mut positions, mut sum) = (Combinations::default(), Sum::default());
        for v in 0..self.first[0] {
            match smooth.filter(|_| !sharp.corners[v as usize]) {
                Some(weights) => self.old(v, sharp, weights, &mut sum),
                None => sum.add(v, 1.0),
            }
            positions.push_sum(&mut sum);
        }
        for (e, &ends) in (0..).zip(self.topology.edges()) {
            match smooth.filter(|_| !sharp.edges[e as usize]) {
                Some(weights) => self.on_edge(e, ends, weights, &mut sum),
                None => ends.into_iter().for_each(|v| sum.add(v, 0.5)),
            }
            positions.push_sum(&mut sum);
        }
        let faces = self.mesh.faces.iter().take(if self.triangles { 0 } else { usize::MAX });
        for face in faces {
            face.iter().for_each(|&v| sum.add(v, 1.0 / face.len() as f64));
            positions.push_sum(&mut sum);
        }
        positions
    }

    /// Adds the combination of the vertex on a smooth edge.
    fn on_edge(&self, e: u32, ends: [u32; 2], weights: Weights, sum: &mut Sum) {
        let [end, beside] = weights.edge;
        ends.into_iter().for_each(|v| sum.add(v, end));
        for &face in self.topology.edge_faces().row(e as usize) {
            self.add_face(sum, face, beside, &ends);
        }
    }

    /// Adds the combination of an old vertex that is not a corner.
    fn old(&self, v: u32, sharp: &Sharp, weights: Weights, sum: &mut Sum) {
        match *sharp.neighbours(self.topology, v) {
            [a, b] => {
                [(v, 0.75), (a, 0.125), (b, 0.125)]
                    .into_iter()
                    .for_each(|(v, part)| sum.add(v, part));
            }
            _ => {
                let faces = self.topology.vertex_faces().row(v as usize);
                let edges = self.topology.vertex_edges().row(v as usize).iter();
                let edges =
                    edges.filter(|&&e| !self.topology.edge_faces().row(e as usize).is_empty());
                let n = edges.clone().count() as f64;
                let [own, all_neighbours, all_faces] = (weights.vertex)(n);
                sum.add(v, own);
                for &e in edges {
                    sum.add(self.topology.other_end(e, v), all_neighbours / n);
                }
                if all_faces > 0.0 {
                    for &face in faces {
                        self.add_face(sum, face, all_faces / faces.len() as f64, &[]);
                    }
                }
            }
        }
    }

    /// Adds the centre of a face or, if triangles are split, its corner that is not in `ends`.
    fn add_face(&self, sum: &mut Sum, face: u32, weight: f64, ends: &[u32]) {
        let corners = self.mesh.faces.row(face as usize);
        let others = corners.iter().filter(|v| !(self.triangles && ends.contains(v)));
        let count = others.clone().count() as f64;
        others.for_each(|&v| sum.add(v, weight / count));
    }
}
