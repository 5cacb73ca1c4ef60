//! The lines of curvature are followed where there are any.

use super::surfaces::{ellipsoid, hypar, plate, torus, tube, vault};
use super::{check, panels, with};
use shape_up::math::Vec3;
use shape_up::mesh::{BoundingSphere, Measures, Mesh};
use shape_up::quads::{MapOptions, PanelSize, Remeshed, Remesher};

#[test]
fn a_torus_a_tube_and_a_plate_have_no_irregular_vertex() {
    for (name, mesh, angle) in [("torus", torus(), 2.0), ("tube", tube(), 1.0)] {
        let found = panels(&mesh, 250).unwrap();
        check(&mesh, &found);
        let irregular = found.measures.irregular;
        assert_eq!((irregular.inside, irregular.boundary), (0, 0), "{name}");
        assert!(found.measures.angle.unwrap().mean < angle, "{name}: {:?}", found.measures.angle);
        assert!((200..=300).contains(&found.measures.quads), "{name}: {:?}", found.measures);
        assert!(found.notes.is_empty() && found.level == 0, "{name}: {:?}", found.notes);
    }
    let found = panels(&plate(), 200).unwrap();
    check(&plate(), &found);
    let irregular = found.measures.irregular;
    assert_eq!((irregular.inside, irregular.boundary), (0, 0));
    assert_eq!(found.measures.angle, None, "a plane has no lines of curvature");
}

#[test]
fn an_ellipsoid_has_eight_irregular_vertices_about_its_four_umbilics() {
    let mesh = ellipsoid([3.0, 2.0, 1.2]);
    let found = panels(&mesh, 300).unwrap();
    check(&mesh, &found);
    assert_eq!(found.measures.irregular.inside, 8);
    assert!(found.measures.angle.unwrap().mean < 5.0, "{:?}", found.measures.angle);
    let sphere = ellipsoid([2.0; 3]);
    let found = panels(&sphere, 300).unwrap();
    check(&sphere, &found);
    assert_eq!(found.measures.irregular.inside, 8);
}

/// Mean distance of the panels from circles, in mean edges.
fn off_circles(found: &Remeshed) -> f64 {
    let diameter = BoundingSphere::of(&found.mesh.positions).diameter();
    let measures = Measures::new(&found.mesh.positions, &found.mesh.faces, diameter);
    measures.circularity.mean_distance / found.measures.edge.mean
}

#[test]
fn following_curvature_brings_panels_nearer_to_circles() {
    for mesh in [hypar(), vault(), ellipsoid([3.0, 2.0, 1.2])] {
        let size = PanelSize::Count(250);
        let aligned = with(&mesh, MapOptions::of_size(size)).unwrap();
        let options = MapOptions { follow: 0.0, direction: 1.0, ..MapOptions::of_size(size) };
        let unaligned = with(&mesh, options).unwrap();
        check(&mesh, &aligned);
        check(&mesh, &unaligned);
        let [on, off] = [&aligned, &unaligned].map(off_circles);
        assert!(on < 0.9 * off, "{on} {off}");
        let [on, off] = [&aligned, &unaligned].map(|found| found.measures.angle.unwrap().mean);
        assert!(on < 0.8 * off, "{on} {off}");
        let irregular = |found: &Remeshed| found.measures.irregular.inside;
        assert!(irregular(&unaligned) <= irregular(&aligned));
    }
}

#[test]
fn a_result_remeshed_at_the_same_size_stays_as_regular() {
    for mesh in [vault(), torus()] {
        let first = panels(&mesh, 300).unwrap();
        let size = PanelSize::Length(first.measures.edge.mean);
        let again = with(&first.mesh, MapOptions::of_size(size)).unwrap();
        check(&first.mesh, &again);
        let [before, after] = [&first, &again].map(|found| found.measures.irregular.inside);
        assert!(before.abs_diff(after) <= 2, "{before} {after}");
    }
}

/// The mirror image, with faces turned so that normals stay on their side.
fn mirrored(mesh: &Mesh) -> Mesh {
    let positions = mesh.positions.iter().map(|&[x, y, z]| [-x, y, z]).collect();
    let mut image = Mesh { positions, ..Mesh::default() };
    for face in mesh.faces.iter() {
        let turned: Vec<u32> = face.iter().rev().copied().collect();
        image.faces.push(&turned);
    }
    image
}

#[test]
fn a_mirrored_surface_gives_the_mirrored_panels() {
    let mesh = vault();
    let found = panels(&mesh, 250).unwrap();
    let image = panels(&mirrored(&mesh), 250).unwrap();
    let expected = mirrored(&found.mesh);
    assert_eq!(image.mesh.faces.len(), expected.faces.len());
    let nearest = |&point: &[f64; 3]| {
        let distance = |&other: &[f64; 3]| (Vec3::from(other) - Vec3::from(point)).length();
        image.mesh.positions.iter().map(distance).fold(f64::INFINITY, f64::min)
    };
    let farthest = expected.positions.iter().map(nearest).fold(0.0, f64::max);
    assert!(farthest < 1e-6, "{farthest}");
}

#[test]
fn more_weight_on_even_panels_makes_them_more_even() {
    let mesh = ellipsoid([3.0, 2.0, 1.2]);
    let cv = |direction: f64| {
        let options = MapOptions { direction, ..MapOptions::of_size(PanelSize::Count(250)) };
        with(&mesh, options).unwrap().measures.edge.cv
    };
    let [even, small_move] = [cv(1.0), cv(100.0)];
    assert!(even < small_move, "{even} {small_move}");
}

#[test]
fn what_was_asked_before_changes_nothing() {
    let mesh = vault();
    let of = |count: usize| MapOptions::of_size(PanelSize::Count(count));
    let asked = [
        of(200),
        MapOptions { direction: 5.0, ..of(200) },
        MapOptions { follow: 5.0, ..of(200) },
        of(120),
        of(200),
    ];
    let mut remesher = Remesher::new(&mesh).unwrap();
    for options in asked {
        let found = remesher.remesh(&options, "m", &mut |_, _| true).unwrap();
        assert_eq!(found.mesh, with(&mesh, options).unwrap().mesh, "{options:?}");
    }
}
