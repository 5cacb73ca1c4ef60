//! What a mesh is made of, by which its size is told: faces, else tetrahedra, else curves.

use super::{BoundingSphere, Mesh, Point, Ragged};
use std::borrow::Cow;

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

    /// The size of the mesh: the diameter of the smallest ball around its faces, in its unit, which is 1 in
    /// the scale of `e_p` and `e_c`. Curves and tetrahedra count only without faces, lone vertices only in a
    /// point set.
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
