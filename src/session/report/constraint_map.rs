//! The row of constraints that each face and each vertex is coloured by.

use crate::math::argsort;
use crate::mesh::{Mesh, Topology};
use crate::session::Session;

/// The row that acts on each face and each vertex. If several do, it is the one with the fewest
/// vertices, which is the most specific; among equal ones the last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConstraintMap {
    /// Per face, a row with a constraint that contains all its corners.
    pub faces: Vec<Option<u32>>,
    /// Per vertex, a row with a constraint on it that covers no whole face: a beam, a rim.
    pub vertices: Vec<Option<u32>>,
}

impl Session {
    /// Returns the enabled row that acts on each face and each vertex.
    pub fn acting_rows(&self) -> ConstraintMap {
        let mesh = self.mesh();
        let mut cover = ConstraintCoverage::new(mesh, self.topology());
        let rows: Vec<_> = (0..).zip(self.rows()).filter(|(_, row)| row.enabled).collect();
        let most_vertices_first = argsort(rows.iter().map(|(_, row)| {
            let mut vertices = row.constraints.members.indices().to_vec();
            vertices.sort_unstable();
            vertices.dedup();
            u64::MAX - vertices.len() as u64
        }));
        let mut acting = ConstraintMap {
            faces: vec![None; mesh.faces.len()],
            vertices: vec![None; mesh.positions.len()],
        };
        for (index, row) in most_vertices_first.into_iter().map(|i| rows[i as usize]) {
            for members in row.constraints.members.iter() {
                let faces = cover.faces(members);
                for &face in faces {
                    acting.faces[face as usize] = Some(index);
                }
                if faces.is_empty() {
                    for &vertex in members {
                        acting.vertices[vertex as usize] = Some(index);
                    }
                }
            }
        }
        acting
    }

    /// Returns the colours of the rows of constraints.
    pub fn row_palette(&self) -> RowPalette {
        let mut palette = RowPalette::default();
        for colour in self.rows().iter().map(|row| row.constraints.kind.info().colour) {
            let known = palette.colours.iter().position(|other| *other == colour);
            let index = known.unwrap_or(palette.colours.len());
            if known.is_none() {
                palette.colours.push(colour);
            }
            palette.of_row.push(u8::try_from(index + 1).expect("there are fewer than 255 kinds"));
        }
        palette
    }
}

/// The colours of the rows of constraints, without duplicates.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RowPalette {
    /// Per row, the index of its colour plus one; 0 is reserved for elements without a row.
    pub of_row: Vec<u8>,
    /// Red, green and blue from 0 to 255.
    pub colours: Vec<[u8; 3]>,
}

/// Finds the faces that sets of vertices cover.
pub(crate) struct ConstraintCoverage<'a> {
    mesh: &'a Mesh,
    topology: &'a Topology,
    /// Per vertex, the last set that contained it.
    set_of: Vec<usize>,
    sets: usize,
    faces: Vec<u32>,
}

impl<'a> ConstraintCoverage<'a> {
    pub(crate) fn new(mesh: &'a Mesh, topology: &'a Topology) -> Self {
        let set_of = vec![0; mesh.positions.len()];
        ConstraintCoverage { mesh, topology, set_of, sets: 0, faces: Vec::new() }
    }

    /// Returns the faces whose corners are all in `set`.
    pub(crate) fn faces(&mut self, set: &[u32]) -> &[u32] {
        self.sets += 1;
        set.iter().for_each(|&vertex| self.set_of[vertex as usize] = self.sets);
        self.faces.clear();
        for &vertex in set {
            for &face in self.topology.vertex_faces().row(vertex as usize) {
                let corners = self.mesh.faces.row(face as usize);
                // Each face is tested once, at its first corner.
                let is_covered = corners[0] == vertex
                    && corners.iter().all(|&corner| self.set_of[corner as usize] == self.sets);
                if is_covered {
                    self.faces.push(face);
                }
            }
        }
        &self.faces
    }
}
