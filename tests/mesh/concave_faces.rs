//! Faces with notches, which their own centre may not see: cut to triangles, split, paired again.

use crate::mesh::operations::{Picked, apply, done, flat, with_vertices};
use shape_up::mesh::{Mesh, read};

#[test]
fn a_concave_quad_is_cut_inside() {
    let text = "v 0 0 0\nv 4 -1 0\nv 1 0.2 0\nv 0 4 0\nf 1 2 3 4\n";
    let dart = read("dart.obj", text.as_bytes()).unwrap().mesh;
    let cut = done(&dart, "triangles").mesh;
    assert!(cut.faces.iter().all(|face| face.contains(&0) && face.contains(&2)));
    assert!(apply(&cut, "quads", None, &Picked::default()).is_err(), "it is not convex");
}

/// A slab with a notch as deep as its centre, and one around its centre.
fn notched() -> [Mesh; 2] {
    let l: &[[u32; 2]] = &[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
    let u: &[[u32; 2]] = &[[0, 0], [3, 0], [3, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]];
    [l, u].map(polygon)
}

/// A face with these corners in the plane.
fn polygon(corners: &[[u32; 2]]) -> Mesh {
    Mesh {
        positions: corners.iter().map(|&[x, y]| [f64::from(x), f64::from(y), 0.0]).collect(),
        faces: [(0..corners.len() as u32).collect::<Vec<u32>>()].into_iter().collect(),
        ..Mesh::default()
    }
}

#[test]
fn a_face_that_its_centre_does_not_see_is_cut_along_diagonals() {
    for (slab, twice) in notched().into_iter().zip([6.0, 14.0]) {
        let cut = done(&slab, "triangles").mesh;
        assert_eq!(cut.positions, slab.positions);
        let areas = cut.faces.iter().map(|face| {
            let [a, b, c] = [0, 1, 2].map(|k| cut.positions[face[k] as usize]);
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        });
        assert!(areas.clone().all(|area| area > 0.1));
        assert_eq!(areas.sum::<f64>(), twice);
    }
    let [_, u] = notched();
    assert!(apply(&u, "split-face", None, &with_vertices(&[3, 6])).is_err(), "it is in the notch");
    assert!(apply(&u, "split-face", None, &with_vertices(&[2, 7])).is_err(), "it crosses it");
    let cut = apply(&u, "split-face", None, &with_vertices(&[0, 4])).unwrap().mesh;
    assert_eq!(cut.faces, [&[0, 1, 2, 3, 4][..], &[4, 5, 6, 7, 0]].into_iter().collect());
    // Corners of the notch on the line, at (1, 2) and (3, 2).
    let corners = [0, 40, 42, 44, 34, 32, 31, 11, 12, 14, 4, 2].map(|xy| [xy / 10, xy % 10]);
    let wide = polygon(&corners);
    assert!(apply(&wide, "split-face", None, &with_vertices(&[2, 11])).is_err());
}

#[test]
fn a_notched_quad_whose_inner_diagonal_is_an_edge_is_not_cut_outside() {
    let text = "v 0 0 0\nv 4 -1 0\nv 1 0.2 0\nv 0 4 0\nv 0 0 3\nf 1 2 3 4\nf 1 3 5\n";
    let cut = done(&read("dart.obj", text.as_bytes()).unwrap().mesh, "triangles").mesh;
    assert_eq!((cut.faces.len(), cut.positions[5]), (5, [0.5, 0.1, 0.0]));
}

#[test]
fn only_faces_around_a_centre_outside_them_are_said_to_be_turned_over() {
    let turned = |mesh: &Mesh, id: &str, vertices: &[u32]| {
        apply(mesh, id, None, &with_vertices(vertices)).unwrap().turned_over(mesh)
    };
    let [_, u] = notched();
    assert!(turned(&u, "diagonal", &[]) > 0);
    // Two faces of opposite orientation.
    let mut flipped = flat(2, 1);
    let mut faces = [0, 1].map(|face| flipped.faces.row(face).to_vec());
    faces[1].reverse();
    flipped.faces = faces.iter().collect();
    assert_eq!(turned(&flipped, "diagonal", &[]), 0);
    // Merged with a corner far away, a vertex goes beyond the far sides of the faces around it.
    let mut grid = flat(4, 4);
    grid.positions[24] = [-9.0, -9.0, 0.0];
    assert_eq!(turned(&grid, "merge-vertices", &[6, 8, 24]), 0);
}
