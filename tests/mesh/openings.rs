//! Holes of a mesh, and faces with windows.

use crate::mesh::operations::{Picked, apply, area, done, flat, with_vertices};
use crate::mesh::subdivide::most_alike;
use crate::support::grid::wall_on_floor;
use shape_up::mesh::{Edited, Mesh, OperationError, Topology};

#[test]
fn holes_are_closed_and_the_outline_stays() {
    let mut mesh = flat(5, 5);
    let whole = mesh.clone();
    mesh.faces = mesh
        .faces
        .iter()
        .enumerate()
        .filter(|(f, _)| ![6, 12, 18].contains(f))
        .map(|(_, face)| face)
        .collect();
    let filled = done(&mesh, "fill").mesh;
    assert_eq!(filled.faces.len(), 25);
    assert_eq!(most_alike(&filled), 1);
    assert!((area(&filled) - 25.0).abs() < 1e-12);
    let one = apply(&mesh, "fill", None, &with_vertices(&[7])).unwrap().mesh;
    assert_eq!(one.faces.len(), 23, "only the hole with that vertex");
    let none = apply(&whole, "fill", None, &Picked::default());
    assert!(matches!(none, Err(OperationError::Expected(_))));
    let closed = apply(&whole, "fill", None, &with_vertices(&[0])).unwrap().mesh;
    assert_eq!(closed.faces.row(25).len(), 20);
    assert_eq!(Topology::new(&closed).boundary_loops().len(), 0);
    for id in ["fill", "extrude"] {
        let refused = apply(&closed, id, None, &Picked::default());
        assert_eq!(refused, Err(OperationError::NoBoundary));
    }
    // Each of two pieces has an outline.
    let mut two = mesh.clone();
    two.positions.extend(mesh.positions.iter().map(|&[x, y, z]| [x + 9.0, y, z]));
    mesh.faces.iter().for_each(|face| {
        two.faces.push(&face.iter().map(|v| v + 36).collect::<Vec<_>>());
    });
    let filled = done(&two, "fill").mesh;
    assert_eq!((filled.faces.len(), Topology::new(&filled).boundary_loops().len()), (50, 2));
    // So has each of two that touch in a corner: one of them got a back face.
    let mut touching = flat(1, 1);
    touching.positions.extend([[2.0, 1.0, 0.0], [2.0, 2.0, 0.0], [1.0, 2.0, 0.0]]);
    touching.faces.push(&[3, 4, 5, 6]);
    let none = apply(&touching, "fill", None, &Picked::default());
    assert!(matches!(none, Err(OperationError::Expected(_))), "{none:?}");
}

/// There was a solid face over a wall with a window, flaps along it, and it kept its side when all others
/// were flipped.
#[test]
fn faces_that_are_left_as_they_are_turn_with_the_others_and_are_no_opening() {
    let mut mesh = flat(3, 3);
    let around = mesh.faces.row(4).to_vec();
    mesh.faces = mesh.faces.iter().filter(|face| *face != around).collect();
    mesh.positions.extend([[1.4, 1.4, 0.0], [1.4, 1.6, 0.0], [1.6, 1.4, 0.0]]);
    let window = [&around[..], &[around[0], 16, 17, 18, 16]].concat();
    mesh.untouched.push(&window);
    for picked in [Picked::default(), with_vertices(&[around[0], 16])] {
        let filled = apply(&mesh, "fill", None, &picked);
        assert!(matches!(filled, Err(OperationError::Expected(_))), "{filled:?}");
    }
    assert_eq!(done(&mesh, "extrude").mesh.faces.len(), 8 + 12, "nothing around the window");
    let turned = |mesh: &Mesh, id: &str| {
        let Edited { mesh: mut made, origins } = done(mesh, id);
        origins.carry(mesh, &mut made);
        made
    };
    let flipped = turned(&mesh, "flip");
    let back: Vec<u32> = window[..1].iter().chain(window[1..].iter().rev()).copied().collect();
    assert_eq!(flipped.untouched.row(0), back);
    assert_eq!(turned(&flipped, "flip"), mesh);
    let one = Mesh { untouched: flipped.untouched, ..mesh.clone() };
    assert_eq!(turned(&one, "unify"), mesh);
}

#[test]
fn the_boundary_of_a_wall_on_a_floor_is_no_hole() {
    let mesh = wall_on_floor();
    for picked in [Picked::default(), with_vertices(&[9])] {
        let filled = apply(&mesh, "fill", None, &picked);
        assert!(matches!(filled, Err(OperationError::Expected(_))), "{filled:?}");
    }
}
