//! Connectivity of vertices, edges and faces, and curves and regions derived from it.
//!
//! All lists are built by sorting, so their order depends on the mesh alone. The mesh need not be a
//! manifold: an edge may have any number of faces, a vertex any number of fans.

mod boundary;
mod components;
mod edge_lines;
mod local;
mod strips;

pub(crate) use components::oriented_areas;
pub use components::{components, orientation};
pub use edge_lines::{Repeated, edge_lines, repeated};
pub use local::{corners, hinges, stars};
pub use strips::strips;

use crate::math::Vec3;
use crate::mesh::sides::sides;
use crate::mesh::{Mesh, Point, Ragged};

/// The adjacency of a mesh. Indices are those of the mesh; edges are numbered in lexicographic
/// order of their ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Topology {
    edges: Vec<[u32; 2]>,
    neighbours: Ragged,
    vertex_edges: Ragged,
    edge_faces: Ragged,
    /// `#E`: see [`Topology::is_of_body`].
    of_body: Vec<bool>,
    /// For each entry of `edge_faces`, whether the face traverses the edge from its first to its second
    /// end. Stored, since to look for an edge among the sides of a face takes long in large faces.
    ascends: Vec<bool>,
    vertex_faces: Ragged,
    boundary_loops: Ragged,
    quad_dominant: bool,
}

impl Topology {
    /// Computes the adjacency of `mesh`. Its edges are the sides of faces, the segments of curves
    /// and the edges of tetrahedra, each once; sides from a vertex to itself are excluded.
    pub fn new(mesh: &Mesh) -> Topology {
        let n_vertices = mesh.positions.len();
        let (sides, body) = (sides(mesh), mesh.body());
        let mut edges = Vec::new();
        let (mut edge_faces, mut of_body) = (Ragged::new(), Vec::new());
        let of_faces = sides.iter().filter(|side| side.face.is_some());
        let ascends: Vec<bool> = of_faces.map(|side| side.ascends).collect();
        for same in sides.chunk_by(|a, b| a.ends == b.ends) {
            edges.push(same[0].ends);
            let faces: Vec<u32> = same.iter().filter_map(|side| side.face).collect();
            edge_faces.push(&faces);
            of_body.push(same.iter().any(|side| side.of == body));
        }
        let numbered = || edges.iter().zip(0..);
        let by_vertex = |of_end: fn([u32; 2], u32, bool) -> u32| {
            let ends = numbered().flat_map(|(&[a, b], e)| {
                [(a, of_end([a, b], e, true)), (b, of_end([a, b], e, false))]
            });
            gather(n_vertices, ends)
        };
        // Edges are in lexicographic order, so both lists are in the order of the neighbours.
        let neighbours = by_vertex(|[a, b], _, first| if first { b } else { a });
        let vertex_edges = by_vertex(|_, e, _| e);
        // List a face once even if it visits the vertex several times.
        let mut last_face = vec![None; n_vertices];
        let corners = mesh.faces.iter().zip(0..);
        let corners = corners.flat_map(|(face, f)| face.iter().map(move |&v| (v, f)));
        let distinct: Vec<(u32, u32)> =
            corners.filter(|&(v, f)| last_face[v as usize].replace(f) != Some(f)).collect();
        let vertex_faces = gather(n_vertices, distinct.iter().copied());
        let boundary_loops =
            boundary::boundary_loops(n_vertices, &edges, &vertex_edges, (&edge_faces, &ascends));
        let quads = mesh.faces.iter().filter(|face| face.len() == 4).count();
        Topology {
            quad_dominant: 2 * quads > mesh.faces.len(),
            edges,
            neighbours,
            vertex_edges,
            edge_faces,
            of_body,
            ascends,
            vertex_faces,
            boundary_loops,
        }
    }

    /// `#E by 2`: the ends of each edge, the lower first, in lexicographic order.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }
    /// Returns the edge between two vertices.
    pub fn edge(&self, a: u32, b: u32) -> Option<u32> {
        self.edges.binary_search(&[a.min(b), a.max(b)]).ok().map(|e| e as u32)
    }
    /// Returns the edge between two vertices if it [is of the body](Topology::is_of_body).
    pub fn body_edge(&self, a: u32, b: u32) -> Option<u32> {
        self.edge(a, b).filter(|&e| self.is_of_body(e))
    }
    /// Returns the end of edge `e` that is not `v`.
    pub fn other_end(&self, e: u32, v: u32) -> u32 {
        let [a, b] = self.edges[e as usize];
        if a == v { b } else { a }
    }
    /// `#V` rows: the vertices that share an edge with a vertex, `N(i)` of Eq. 12, ascending.
    pub fn neighbours(&self) -> &Ragged {
        &self.neighbours
    }
    /// `#V` rows: the edges at a vertex, each at the index of its other end in
    /// [`Topology::neighbours`].
    pub fn vertex_edges(&self) -> &Ragged {
        &self.vertex_edges
    }
    /// `#E` rows: the faces that have an edge as a side, ascending. An edge with one face is on the
    /// boundary, an edge without faces belongs to curves or tetrahedra only, and an edge with three
    /// or more is not manifold. A face that traverses the edge twice is listed twice.
    pub fn edge_faces(&self) -> &Ragged {
        &self.edge_faces
    }
    /// For each face of edge `e`, in the order of [`Topology::edge_faces`], whether it traverses the edge
    /// from its first to its second end. Two faces that agree in that face opposite ways.
    pub fn edge_ascends(&self, e: u32) -> &[bool] {
        let [from, to] = [e, e + 1].map(|e| self.edge_faces.offsets()[e as usize] as usize);
        &self.ascends[from..to]
    }
    /// The sign of the second normal of an edge of two faces beside the first one's: -1 if the faces
    /// traverse the edge in the same direction, so that they face opposite ways.
    pub(crate) fn agreement(&self, e: u32) -> f64 {
        let ascends = self.edge_ascends(e);
        if ascends[0] == ascends[1] { -1.0 } else { 1.0 }
    }
    /// Whether edge `e` belongs to what the mesh is made of: to a face; without faces, to a
    /// tetrahedron; without either, to a curve.
    pub fn is_of_body(&self, e: u32) -> bool {
        self.of_body[e as usize]
    }
    /// The ends of the edges [`Topology::is_of_body`], in their order.
    pub fn body_edges(&self) -> impl Iterator<Item = [u32; 2]> {
        let edges = self.edges.iter().zip(&self.of_body);
        edges.filter_map(|(&ends, &of_body)| of_body.then_some(ends))
    }
    /// Those of the [`Topology::neighbours`] of a vertex to which such an edge leads, ascending.
    pub fn body_neighbours(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let [neighbours, edges] =
            [&self.neighbours, &self.vertex_edges].map(|rows| rows.row(vertex as usize));
        let pairs = neighbours.iter().zip(edges);
        pairs.filter_map(|(&v, &e)| self.is_of_body(e).then_some(v))
    }
    /// Mean length of such an edge at `positions`, `#V by 3`, in their unit; zero without any.
    pub fn mean_edge(&self, positions: &[Point]) -> f64 {
        let at = |v: u32| Vec3::from(positions[v as usize]);
        let sum: f64 = self.body_edges().map(|[a, b]| (at(b) - at(a)).length()).sum();
        sum / self.body_edges().count().max(1) as f64
    }

    /// Whether edge `e` has exactly one face.
    pub fn is_boundary_edge(&self, e: u32) -> bool {
        self.edge_faces.row(e as usize).len() == 1
    }
    /// `#V` rows: the faces that have a vertex as a corner, ascending.
    pub fn vertex_faces(&self) -> &Ragged {
        &self.vertex_faces
    }
    /// The boundary as loops of vertices. Each boundary edge is in exactly one loop, no vertex is
    /// twice in a loop, and the first is not repeated at the end. A loop has the direction of its
    /// faces if they agree. Only where edges of three or more faces meet the boundary, a row can be
    /// an open chain.
    pub fn boundary_loops(&self) -> &Ragged {
        &self.boundary_loops
    }
    /// Whether a row of [`Topology::boundary_loops`] is closed by an edge from its last to its
    /// first vertex.
    pub fn is_closed_loop(&self, row: &[u32]) -> bool {
        let closing = self.edge(row[0], row[row.len() - 1]);
        row.len() > 2 && closing.is_some_and(|e| self.is_boundary_edge(e))
    }
    /// Whether more than half of the faces have four corners.
    pub fn is_quad_dominant(&self) -> bool {
        self.quad_dominant
    }

    /// Returns the vertices within `radius` edges [of the body](Topology::is_of_body) of `vertex`:
    /// itself first, then ring by ring, each ring ascending.
    pub fn ring(&self, vertex: u32, radius: u32) -> Vec<u32> {
        spread(&[vertex], radius, |v| self.body_neighbours(v))
    }

    /// Returns the vertices within `radius` edges of `seed` (distinct vertices): the seed
    /// unchanged, then ring by ring, each ring ascending.
    pub fn grow(&self, seed: &[u32], radius: u32) -> Vec<u32> {
        spread(seed, radius, |v| self.neighbours.row(v as usize).iter().copied())
    }
}

/// Returns the vertices within `radius` steps of `seed`, see [`Topology::grow`].
fn spread<I: Iterator<Item = u32>>(
    seed: &[u32],
    radius: u32,
    neighbours: impl Fn(u32) -> I,
) -> Vec<u32> {
    let mut all = seed.to_vec();
    let mut inner: Vec<u32> = Vec::new();
    let mut ring = seed.to_vec();
    ring.sort_unstable();
    for _ in 0..radius {
        // A neighbour of a ring is in this, the previous or the next ring.
        let mut next: Vec<u32> = ring.iter().flat_map(|&v| neighbours(v)).collect();
        next.sort_unstable();
        next.dedup();
        next.retain(|v| ring.binary_search(v).is_err() && inner.binary_search(v).is_err());
        if next.is_empty() {
            break;
        }
        all.extend_from_slice(&next);
        inner = std::mem::replace(&mut ring, next);
    }
    all
}

/// Groups values by key (a counting sort): row `i` has the values of key `i`, in their order.
fn gather(n_rows: usize, pairs: impl Iterator<Item = (u32, u32)> + Clone) -> Ragged {
    let mut starts = vec![0_u32; n_rows + 1];
    for (key, _) in pairs.clone() {
        starts[key as usize + 1] += 1;
    }
    for i in 0..n_rows {
        starts[i + 1] += starts[i];
    }
    let mut values = vec![0; starts[n_rows] as usize];
    let mut ends = starts.clone();
    for (key, value) in pairs {
        values[ends[key as usize] as usize] = value;
        ends[key as usize] += 1;
    }
    Ragged::from_parts(starts, values)
}
