//! A polygon mesh with curves, tetrahedra and named groups.

use super::file_order::FileOrder;
use crate::math::{Ragged, marked};

/// A position in space, in the units of the mesh.
pub type Point = [f64; 3];

/// A polygon mesh with curves and tetrahedra, as read from a file. Vertices, faces, curves and
/// groups stay in the order of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions of the vertices, `#V by 3`, finite.
    pub positions: Vec<Point>,
    /// The corners of each face, at least three, as indices of vertices.
    pub faces: Ragged,
    /// The vertices of each polyline, at least two; a closed one repeats its first vertex at the
    /// end.
    pub curves: Ragged,
    /// `#T by 4` indices of vertices.
    pub tets: Vec<[u32; 4]>,
    /// Named sets of faces and curves, which may overlap; none is empty. From a file they are in
    /// the order of their first members.
    pub groups: Vec<Group>,
    /// Faces that visit a vertex twice, as those with a hole at the end of a slit: not solved, built only as
    /// panels with holes, and written as they came. None of [`Mesh::groups`] has them.
    pub untouched: Ragged,
    /// The vertices, ascending, whose positions are not in the file, since a coordinate is no number.
    /// Nothing is built of their faces.
    pub unplaced: Vec<u32>,
    /// The order of the OBJ file that it was read from.
    pub order: FileOrder,
}

impl Mesh {
    /// Its faces, and those that are left as they are: what a format without other names for them is
    /// given.
    pub(crate) fn all_faces(&self) -> impl Iterator<Item = &[u32]> + Clone {
        self.faces.iter().chain(self.untouched.iter())
    }

    /// Whether the position of a vertex is not in the file.
    pub(crate) fn is_unplaced(&self, vertex: u32) -> bool {
        self.unplaced.binary_search(&vertex).is_ok()
    }

    /// Its faces, ascending, with a vertex whose position is not in the file, except those that are to
    /// stay as they are: no surface to lay panels on.
    pub(crate) fn faces_left_out(&self, staying: &[u32]) -> Vec<u32> {
        let stays = marked(self.faces.len(), staying);
        let rows = (0..).zip(self.faces.iter()).zip(stays);
        let others = rows.filter_map(|(row, stays)| (!stays).then_some(row));
        let is_out = |face: &[u32]| face.iter().any(|&v| self.is_unplaced(v));
        others.filter_map(|(f, face)| is_out(face).then_some(f)).collect()
    }

    /// Its vertices, with the faces but these: a mesh without curves, groups and all else.
    pub(crate) fn without_faces(&self, faces: &[u32]) -> Mesh {
        let gone = marked(self.faces.len(), faces);
        let kept = self.faces.iter().zip(gone).filter(|(_, gone)| !gone).map(|(face, _)| face);
        Mesh { positions: self.positions.clone(), faces: kept.collect(), ..Mesh::default() }
    }

    /// Whether one of its groups has this name.
    pub(crate) fn has_group(&self, name: &str) -> bool {
        self.groups.iter().any(|group| group.name == name)
    }

    /// Returns the mesh with other positions, `#V by 3`.
    pub(crate) fn at(&self, positions: &[Point]) -> Mesh {
        Mesh { positions: positions.to_vec(), ..self.clone() }
    }
}

/// A named set of faces and curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The name in the file.
    pub name: String,
    /// The OBJ statement that named it.
    pub keyword: GroupKeyword,
    /// Indices of faces, ascending.
    pub faces: Vec<u32>,
    /// Indices of curves, ascending.
    pub curves: Vec<u32>,
}

/// OBJ statement that opens a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum GroupKeyword {
    /// `o`
    Object,
    /// `g`
    Group,
    /// `usemtl`
    Material,
}

impl GroupKeyword {
    /// The keyword of each statement.
    pub const STATEMENTS: [(&str, GroupKeyword); 3] = [
        ("o", GroupKeyword::Object),
        ("g", GroupKeyword::Group),
        ("usemtl", GroupKeyword::Material),
    ];
}
