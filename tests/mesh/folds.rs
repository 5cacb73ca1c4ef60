//! Faces that are folded over or dented by a change of shape.

use crate::support::meshes::grid;
use proptest::prelude::*;
use shape_up::mesh::{Mesh, Point, Ragged, Topology, folded_faces};

fn flat() -> Mesh {
    grid(4, 3, |i, j| [f64::from(i), f64::from(j), 0.0])
}

fn folded(mesh: &Mesh, now: &[Point]) -> Vec<u32> {
    folded_faces(mesh, &Topology::new(mesh), now)
}

/// The vertices of `mesh` at `x`.
fn column(mesh: &Mesh, x: f64) -> Vec<usize> {
    (0..mesh.positions.len()).filter(|&v| mesh.positions[v][0] == x).collect()
}

#[test]
fn a_strip_that_lies_on_its_neighbour_is_folded_with_it() {
    let mesh = flat();
    let mut now = mesh.positions.clone();
    // The last column is folded back over the one before it.
    column(&mesh, 4.0).into_iter().for_each(|v| now[v] = [2.2, now[v][1], 0.1]);
    let strip =
        |f: &u32| mesh.faces.row(*f as usize).iter().any(|&v| mesh.positions[v as usize][0] >= 3.0);
    let of_last: Vec<u32> = (0..mesh.faces.len() as u32)
        .filter(strip)
        .filter(|&f| {
            mesh.faces.row(f as usize).iter().all(|&v| mesh.positions[v as usize][0] >= 2.0)
        })
        .collect();
    assert_eq!(folded(&mesh, &now), of_last);
    assert_eq!(of_last.len(), 6);
    // The orientation of faces makes no difference.
    let turned = mesh.faces.iter().enumerate().map(|(f, face)| {
        let mut face = face.to_vec();
        if f % 3 == 0 {
            face.reverse();
        }
        face
    });
    let turned = Mesh { faces: Ragged::from_iter(turned.collect::<Vec<_>>()), ..mesh.clone() };
    assert_eq!(folded(&turned, &now), of_last);
    // Folds of the rest mesh are not reported.
    assert_eq!(folded(&Mesh { positions: now.clone(), ..mesh }, &now), Vec::<u32>::new());
}

#[test]
fn a_face_is_dented_where_a_corner_turns_the_other_way() {
    let mesh = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let corner = (0..4).find(|&v| mesh.positions[v] == [1.0, 1.0, 0.0]).unwrap();
    let moved = |to: f64| {
        let mut now = mesh.positions.clone();
        now[corner] = [to, to, 0.0];
        folded(&mesh, &now).len()
    };
    assert_eq!([0.2, 0.4, 0.6, 0.9].map(moved), [1, 1, 0, 0]);
    // Two corners are swapped: the outline crosses itself.
    let mut now = mesh.positions.clone();
    let other = (0..4).find(|&v| mesh.positions[v] == [1.0, 0.0, 0.0]).unwrap();
    now[corner] = [1.0, -0.4, 0.0];
    now[other] = [1.0, 0.8, 0.0];
    assert_eq!(folded(&mesh, &now), [0]);
    // So it does where its two loops are equal: it has no area, and used to have no normal.
    (now[corner], now[other]) = ([1.0, 0.0, 0.0], [1.0, 1.0, 0.0]);
    assert_eq!(folded(&mesh, &now), [0]);
    // A face that is a line crosses nothing.
    let line: Vec<Point> = mesh.positions.iter().map(|&[x, _, _]| [x, 0.0, 0.0]).collect();
    assert_eq!(folded(&mesh, &line), Vec::<u32>::new());
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(64))]

    #[test]
    fn bending_and_moving_fold_nothing(
        k in -0.3..0.3_f64,
        scale in 1e-3..1e3_f64,
        [a, b, c] in prop::array::uniform3(-10.0..10.0_f64),
    ) {
        let mesh = grid(6, 6, |i, j| [f64::from(i), f64::from(j), 0.0]);
        let bent = mesh.positions.iter().map(|&[x, y, _]| {
            [scale * x + a, scale * y + b, scale * k * (x * x - x * y) + c]
        });
        let bent: Vec<Point> = bent.collect();
        prop_assert!(folded(&mesh, &bent).is_empty());
    }
}
