//! The time of operations on large meshes does not grow with the square of their size.

use crate::mesh::operations::{Picked, apply, done, flat};
use shape_up::mesh::{Group, GroupKeyword, Mesh, Scheme, Subdivision, Topology};
use std::f64::consts::TAU;

/// The least time of three that an operation takes.
fn seconds(mesh: &Mesh, id: &str, sizes: Option<&[f64]>) -> f64 {
    let once = || {
        let begun = std::time::Instant::now();
        // Whether the operation is refused does not matter.
        let _ = apply(mesh, id, sizes, &Picked::default());
        begun.elapsed().as_secs_f64()
    };
    (0..3).map(|_| once()).fold(f64::INFINITY, f64::min)
}

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
    let [one, each] = [one, each].map(|mesh| seconds(&mesh, "flip", None));
    assert!(each < 15.0 * one, "{each} s beside {one} s");
}

#[test]
fn welding_at_many_edge_lengths_takes_not_much_longer_than_at_a_small_distance() {
    let mesh = flat(200, 200);
    let [near, far] = [0.01, 10.0].map(|distance| seconds(&mesh, "weld", Some(&[distance])));
    assert!(far < 5.0 * near, "{far} s beside {near} s");
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
    let seconds = |mesh: &Mesh| {
        let twice = Subdivision { scheme: Scheme::CatmullClark, levels: 2, keep: 75.0 };
        let begun = std::time::Instant::now();
        let refined = twice.apply(mesh, &Topology::new(mesh)).expect("it is a face");
        assert_eq!(refined.mesh.faces.len(), 4 * mesh.faces.indices().len());
        begun.elapsed().as_secs_f64()
    };
    // Of the slab, each vertex near the middle is of all 800 corners.
    let [one, many] = [slab(800), flat(40, 40)].map(|mesh| seconds(&mesh));
    assert!(one < 10.0 * many, "{one} s beside {many} s");
}
