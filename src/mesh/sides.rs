//! The sides of all elements, grouped by edge.

use super::{Body, Mesh};
use crate::math::{argsort, key_of_pair, polygon_sides};

/// One side of a face, one segment of a curve or one edge of a tetrahedron.
#[derive(Clone, Copy)]
pub(super) struct Side {
    /// The lower vertex first.
    pub(super) ends: [u32; 2],
    /// Its kind of element.
    pub(super) of: Body,
    /// `None` for curves and tetrahedra.
    pub(super) face: Option<u32>,
    /// Whether it is traversed from the lower vertex to the higher.
    pub(super) ascends: bool,
}

/// Returns all sides, sorted by ends, then by face.
pub(super) fn sides(mesh: &Mesh) -> Vec<Side> {
    const TET_EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    let of_faces =
        mesh.faces.iter().zip(0..).flat_map(|(face, f)| {
            polygon_sides(face).map(move |ends| (ends, Body::Faces, Some(f)))
        });
    let of_curves = mesh
        .curves
        .iter()
        .flat_map(|curve| curve.windows(2).map(|ends| ([ends[0], ends[1]], Body::Curves, None)));
    let of_tets = mesh
        .tets
        .iter()
        .flat_map(|tet| TET_EDGES.map(|[a, b]| ([tet[a], tet[b]], Body::Tetrahedra, None)));
    // Faces come last and in order, and the sort is stable, so the sides of an edge are, too.
    let sides: Vec<Side> = of_curves
        .chain(of_tets)
        .chain(of_faces)
        .filter(|([a, b], ..)| a != b)
        .map(|([a, b], of, face)| Side { ends: [a.min(b), a.max(b)], of, face, ascends: a < b })
        .collect();
    let order = argsort(sides.iter().map(|side| key_of_pair(side.ends)));
    order.into_iter().map(|side| sides[side as usize]).collect()
}

/// Returns those of faces only.
pub(super) fn sides_of_faces(mesh: &Mesh) -> Vec<Side> {
    let mut sides = sides(mesh);
    sides.retain(|side| side.face.is_some());
    sides
}
