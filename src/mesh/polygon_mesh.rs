//! A polygon mesh with curves, tetrahedra and named groups.

use super::bounds::BoundingSphere;
use super::file_order::FileOrder;
use super::ragged::Ragged;
use std::borrow::Cow;

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
    /// Faces that visit a vertex twice, as those with a hole at the end of a slit: neither solved nor
    /// built, and written as they came. None of [`Mesh::groups`] has them.
    pub untouched: Ragged,
    /// The vertices, ascending, whose positions are not in the file, since a coordinate is no number.
    /// Nothing is built of their faces.
    pub unplaced: Vec<u32>,
    /// The order of the OBJ file that it was read from.
    pub order: FileOrder,
}

impl Mesh {
    /// The positions of the vertices of faces, curves and tetrahedra; of a point set, all: where
    /// something is. Files have stray vertices, often at the origin.
    pub fn used_positions(&self) -> Cow<'_, [Point]> {
        let tets = self.tets.as_flattened();
        let [faces, curves, untouched] =
            [&self.faces, &self.curves, &self.untouched].map(Ragged::indices);
        at_vertices(&self.positions, &[faces, curves, tets, untouched])
    }

    /// What the mesh is made of.
    pub(crate) fn body(&self) -> Body {
        if !self.faces.is_empty() {
            Body::Faces
        } else if !self.tets.is_empty() {
            Body::Tetrahedra
        } else if !self.curves.is_empty() {
            Body::Curves
        } else {
            Body::Points
        }
    }

    /// The entries of `positions` (`#V by 3`) at the vertices of its [`Body`].
    pub(crate) fn body_of<'a>(&self, positions: &'a [Point]) -> Cow<'a, [Point]> {
        let untouched = self.untouched.indices();
        match self.body() {
            Body::Faces => at_vertices(positions, &[self.faces.indices(), untouched]),
            Body::Tetrahedra => at_vertices(positions, &[self.tets.as_flattened()]),
            Body::Curves => at_vertices(positions, &[self.curves.indices()]),
            Body::Points => at_vertices(positions, &[untouched]),
        }
    }

    /// The size of the mesh: the diameter of the smallest ball around its faces, in its unit. Curves
    /// and tetrahedra count only without faces, lone vertices only in a point set.
    pub fn size(&self) -> f64 {
        BoundingSphere::of(&self.body_of(&self.positions)).diameter()
    }
}

/// What a mesh is made of. It alone decides how large the mesh is, how long its edges are and how it
/// is curved: guide lines and the outline of a site beside it change nothing of that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Body {
    /// Of faces, if it has any.
    Faces,
    /// Else of tetrahedra.
    Tetrahedra,
    /// Else of curves.
    Curves,
    /// It has no elements.
    Points,
}

/// The entries of `positions` at the vertices of `lists`; all if these have none.
pub(crate) fn at_vertices<'a>(positions: &'a [Point], lists: &[&[u32]]) -> Cow<'a, [Point]> {
    let mut used = vec![false; positions.len()];
    lists.iter().copied().flatten().for_each(|&v| used[v as usize] = true);
    let count = used.iter().filter(|used| **used).count();
    if count == 0 || count == used.len() {
        return Cow::Borrowed(positions);
    }
    let pairs = positions.iter().zip(used);
    pairs.filter_map(|(&point, used)| used.then_some(point)).collect()
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
