//! The time of operations on large meshes does not grow with the square of their size.

use crate::mesh::operations::{Picked, apply, done, flat};
use crate::support::time::takes_less;
use shape_up::mesh::{Group, GroupKeyword, Mesh, Scheme, Subdivision, Topology};
use std::f64::consts::TAU;

#[test]
fn a_group_for_each_face_takes_not_much_longer_than_one_for_all() {
    let mut one = flat(200, 200);
    let group = |name: String, faces: Vec<u32>| Group {
        name,
        keyword: GroupKeyword::Object,
        faces,
        curves: Vec::new(),
    };
    one.groups = vec![group("all".to_owned(), (0..40_000).collect())];
    let mut each = one.clone();
    each.groups = (0..40_000).map(|face| group(format!("panel {face}"), vec![face])).collect();
    let cut = done(&each, "triangles").mesh;
    assert!((0..).zip(&cut.groups).all(|(k, group)| group.faces == [2 * k, 2 * k + 1]));
    let flip = |mesh: &Mesh| {
        done(mesh, "flip");
    };
    takes_less(15.0, || flip(&each), || flip(&one));
}

#[test]
fn welding_at_many_edge_lengths_takes_not_much_longer_than_at_a_small_distance() {
    let mesh = flat(200, 200);
    let weld = |distance: f64| {
        // Whether the operation is refused does not matter.
        let _ = apply(&mesh, "weld", Some(&[distance]), &Picked::default());
    };
    takes_less(5.0, || weld(10.0), || weld(0.01));
}

#[test]
fn a_face_of_many_corners_is_refined_in_the_time_of_its_square() {
    let slab = |corners: u32| {
        let angle = |k| TAU * f64::from(k) / f64::from(corners);
        let at = |k| [libm::cos(angle(k)), libm::sin(angle(k)), 0.0];
        let mut mesh = Mesh { positions: (0..corners).map(at).collect(), ..Mesh::default() };
        mesh.faces.push(&(0..corners).collect::<Vec<u32>>());
        mesh
    };
    let refine = |mesh: &Mesh| {
        let twice = Subdivision { scheme: Scheme::CatmullClark, levels: 2, keep: 75.0 };
        let refined = twice.apply(mesh, &Topology::new(mesh)).expect("it is a face");
        assert_eq!(refined.mesh.faces.len(), 4 * mesh.faces.indices().len());
    };
    // Of the slab, each vertex near the middle is of all 800 corners.
    let [one, many] = [slab(800), flat(40, 40)];
    takes_less(10.0, || refine(&one), || refine(&many));
}
