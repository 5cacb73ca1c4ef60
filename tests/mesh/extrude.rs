//! Rows of quads along a boundary.

use crate::mesh::operations::{Picked, apply, area, flat, with_vertices};
use crate::mesh::subdivide::most_alike;
use shape_up::mesh::{Edited, Mesh};

#[test]
fn a_flat_boundary_goes_outward_as_far_as_asked() {
    let mesh = flat(4, 3);
    let sizes = [0.5, 0.0];
    let Edited { mesh: wider, .. } =
        apply(&mesh, "extrude", Some(&sizes), &Picked::default()).unwrap();
    assert_eq!(wider.faces.len(), 12 + 14);
    assert!((area(&wider) - 5.0 * 4.0).abs() < 1e-12, "corners too: {}", area(&wider));
    assert_eq!(most_alike(&wider), 1);
    let down = apply(&mesh, "extrude", Some(&[0.0, -2.0]), &with_vertices(&[0, 1, 2])).unwrap();
    assert_eq!(down.mesh.faces.len(), 14);
    assert!(down.mesh.positions[20..].iter().all(|p| p[2] == -2.0 && p[1] == 0.0));
    assert!(down.origins.faces.row(13).len() == 1, "a wall belongs to the face that it hangs on");
}

/// There was a gap in the row beside a face with a window.
#[test]
fn a_face_with_a_window_at_the_boundary_is_widened_like_the_others() {
    let mut mesh = flat(3, 1);
    let corner = mesh.faces.row(0).to_vec();
    mesh.faces = mesh.faces.iter().skip(1).collect();
    mesh.positions.extend([[0.4, 0.4, 0.0], [0.4, 0.6, 0.0], [0.6, 0.4, 0.0]]);
    let made = |face: Vec<u32>| {
        let mesh = Mesh { untouched: [face].into_iter().collect(), ..mesh.clone() };
        apply(&mesh, "extrude", Some(&[1.0, 0.0]), &Picked::default()).unwrap()
    };
    let widened = made([&corner[..], &[corner[0], 8, 9, 10, 8]].concat());
    assert_eq!(widened.mesh.faces.len(), 2 + 8);
    assert!((area(&widened.mesh) - (5.0 * 3.0 - 1.0)).abs() < 1e-12, "{}", area(&widened.mesh));
    assert_eq!(widened.origins.faces.iter().filter(|from| from.is_empty()).count(), 3);
}

#[test]
fn a_row_of_quads_around_a_sharp_corner_has_no_spike() {
    // A corner of six degrees, whose sides would meet at nineteen times the distance.
    let positions = vec![[0.0, 0.0, 0.0], [10.0, -0.5, 0.0], [10.0, 0.5, 0.0]];
    let faces = [&[0, 1, 2][..]].into_iter().collect();
    let mesh = Mesh { positions, faces, ..Mesh::default() };
    let Edited { mesh: wider, .. } =
        apply(&mesh, "extrude", Some(&[0.5, 0.0]), &Picked::default()).unwrap();
    let [x, y, _] = wider.positions[3];
    assert!((x + 1.0).abs() < 1e-12 && y.abs() < 1e-12, "twice the distance: {x}, {y}");
}

/// A side without length counted as one at right angles to every other: its ends went twice as far.
#[test]
fn a_side_without_length_and_a_face_without_area_change_nothing() {
    let wider = |positions: &[[f64; 2]], faces: &[&[u32]]| {
        let positions = positions.iter().map(|&[x, y]| [x, y, 0.0]).collect();
        let mesh = Mesh { positions, faces: faces.iter().collect(), ..Mesh::default() };
        let made = apply(&mesh, "extrude", Some(&[1.0, 0.0]), &Picked::default()).unwrap();
        area(&made.mesh)
    };
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let [a, b, c, d] = square;
    assert!((wider(&square, &[&[0, 1, 2, 3]]) - 9.0).abs() < 1e-12);
    // A corner three times, and the middle of a side twice.
    let doubled = [a, b, b, b, c, [0.5, 1.0], [0.5, 1.0], d];
    assert!((wider(&doubled, &[&[0, 1, 2, 3, 4, 5, 6, 7]]) - 9.0).abs() < 1e-12);
    // Slivers over a whole side, and over a part of one.
    let thin = [a, b, c, d, [0.3, 0.0], [0.1 + 0.2, 1.0], [0.6, 1.0]];
    let faces: [&[u32]; 3] = [&[0, 1, 2, 6, 3], &[0, 4, 1], &[3, 6, 5]];
    assert!((wider(&thin, &faces) - 9.0).abs() < 1e-12);
}
