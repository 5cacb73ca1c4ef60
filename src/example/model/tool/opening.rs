//! Removes faces from a mesh.

use crate::mesh::{Mesh, Point, Ragged};

/// The mesh without the faces for whose centroid `is_open` is true, and without the vertices then
/// unused; the rest keeps its order.
pub fn opened(mesh: &Mesh, is_open: impl Fn(Point) -> bool) -> Mesh {
    let middle = |face: &[u32]| {
        let sum = face.iter().fold([0.0; 3], |sum, &v| {
            let p = mesh.positions[v as usize];
            [sum[0] + p[0], sum[1] + p[1], sum[2] + p[2]]
        });
        sum.map(|x| x / face.len() as f64)
    };
    let kept: Vec<&[u32]> = mesh.faces.iter().filter(|face| !is_open(middle(face))).collect();
    let mut number = vec![None; mesh.positions.len()];
    kept.iter().copied().flatten().for_each(|&v| number[v as usize] = Some(0));
    let mut positions = Vec::new();
    for (number, &position) in number.iter_mut().zip(&mesh.positions) {
        if let Some(number) = number {
            *number = positions.len() as u32;
            positions.push(position);
        }
    }
    let mut faces = Ragged::new();
    for face in kept {
        let corners = face.iter().map(|&v| number[v as usize].expect("its corners are kept"));
        faces.push(&corners.collect::<Vec<u32>>());
    }
    Mesh { positions, faces, ..Mesh::default() }
}
