//! Operations on meshes that cannot be performed: the reason is said, and is the one that holds.

use super::operations::{Picked, apply, flat, with_vertices};
use shape_up::mesh::{Edited, Mesh, OperationError, SizeError, read};

#[test]
fn what_cannot_be_done_is_said() {
    let mesh = flat(2, 2);
    let sentence = |found: Result<Edited, OperationError>| found.unwrap_err().to_string();
    let nothing = Picked::default();
    assert_eq!(sentence(apply(&mesh, "iron", None, &nothing)), "there is no operation `iron`");
    assert_eq!(sentence(apply(&mesh, "delete", None, &nothing)), "this needs selected faces");
    assert_eq!(sentence(apply(&mesh, "dual", Some(&[]), &nothing)), "expected 1 sizes, found 0");
    assert_eq!(
        sentence(apply(&mesh, "dual", Some(&[200.0]), &nothing)),
        "Keep corners that turn by more than: expected an angle in degrees from 0 to 180, found 200"
    );
    assert_eq!(
        sentence(apply(&mesh, "weld", None, &with_vertices(&[99]))),
        "there is no vertex 99"
    );
    assert_eq!(sentence(apply(&Mesh::default(), "dual", None, &nothing)), "the mesh has no faces");
    let tets = Mesh { tets: vec![[0, 1, 3, 4]], ..mesh.clone() };
    assert!(sentence(apply(&tets, "dual", None, &nothing)).contains("1 tetrahedron"));
    let snapped = sentence(apply(&mesh, "snap", Some(&[1.0]), &nothing));
    assert_eq!(snapped, "this would change nothing");
    let strip =
        "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 0 1 2\nv 1 1 2\nf 1 2 4 3\nf 3 4 6 5\nf 5 6 1 2\n";
    let moebius = read("moebius.obj", strip.as_bytes()).unwrap().mesh;
    assert!(
        sentence(apply(&moebius, "unify", None, &nothing)).contains("not, like a Moebius strip")
    );
    let nan = [f64::NAN];
    let Err(OperationError::Size(SizeError::Outside { .. })) =
        apply(&mesh, "weld", Some(&nan), &nothing)
    else {
        panic!("no number is no distance");
    };
}

#[test]
fn the_reason_is_the_one_that_holds() {
    let sentence = |mesh: &Mesh, id: &str, sizes: Option<&[f64]>, picked: &[u32]| {
        apply(mesh, id, sizes, &with_vertices(picked)).unwrap_err().to_string()
    };
    // Two squares that share one vertex.
    let mut touching = flat(2, 2);
    touching.faces = [[0, 1, 4, 3], [4, 5, 8, 7]].into_iter().collect();
    let said = sentence(&touching, "dual", None, &[]);
    assert!(said.contains("touch at a vertex") && !said.contains("orientation"), "{said}");
    let mut turned = flat(2, 1);
    turned.faces = [[0, 1, 4, 3], [1, 4, 5, 2]].into_iter().collect();
    assert!(sentence(&turned, "dual", None, &[]).contains("apply Unify orientation"));
    // A quad whose opposite corners are merged; only for welding there is a distance to change.
    let mut slender = flat(1, 1);
    slender.positions[3] = [0.1, 0.0, 0.0];
    let touches = "face 0 would touch itself";
    assert_eq!(sentence(&slender, "merge-vertices", None, &[0, 3]), touches);
    let welded = sentence(&slender, "weld", Some(&[0.2]), &[]);
    assert_eq!(welded, format!("{touches}; try a smaller distance"));
}
