//! The lines of curvature are followed where there are any.

use super::surfaces::{ellipsoid, groin, hypar, plate, torus, tube, vault};
use super::{check, panels, with};
use crate::support::random::{Random, in_frame};
use crate::support::shared;
use shape_up::math::{Vec3, twice_vector_area};
use shape_up::mesh::{Mesh, Topology};
use shape_up::quads::{MapOptions, PanelSize, Remeshed, Remesher};
use shape_up::scene::Scene;
use shape_up::session::Session;
use shape_up::solve::Require;
use std::collections::BTreeMap;

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

/// The mean way of the vertices to circular panels, in mean edges.
fn circular_move(found: &Remeshed) -> f64 {
    let mut scene = Scene::opened("panels.obj");
    scene.request_panels("circle", Require::Soft, &found.mesh).unwrap();
    let mut session = Session::open(scene, found.mesh.clone()).unwrap();
    session.solve(false).unwrap();
    session.moved().mean / found.measures.edge.mean
}

#[test]
fn panels_along_known_lines_of_curvature_hardly_move_to_become_circular() {
    for (name, mesh, most) in [
        ("torus", torus(), 0.01),
        ("tube", tube(), 0.002),
        ("ellipsoid", ellipsoid([3.0, 2.0, 1.2]), 0.05),
    ] {
        let moved = circular_move(&panels(&mesh, 300).unwrap());
        assert!(moved <= most, "{name}: {moved}");
    }
}

#[test]
fn following_curvature_makes_the_way_to_circular_panels_shorter() {
    for mesh in [hypar(), vault(), ellipsoid([3.0, 2.0, 1.2])] {
        let size = PanelSize::Count(250);
        let aligned = with(&mesh, MapOptions::of_size(size)).unwrap();
        let options = MapOptions { follow: 0.0, direction: 1.0, ..MapOptions::of_size(size) };
        let unaligned = with(&mesh, options).unwrap();
        check(&mesh, &aligned);
        check(&mesh, &unaligned);
        let [on, off] = [&aligned, &unaligned].map(circular_move);
        assert!(on < off, "{on} {off}");
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

/// The largest distance of a vertex of a mesh from the nearest one of another with as many faces.
fn apart(mesh: &Mesh, other: &Mesh) -> f64 {
    assert_eq!(mesh.faces.len(), other.faces.len());
    let nearest = |&point: &[f64; 3]| {
        let distance = |&at: &[f64; 3]| (Vec3::from(at) - Vec3::from(point)).length();
        other.positions.iter().map(distance).fold(f64::INFINITY, f64::min)
    };
    mesh.positions.iter().map(nearest).fold(0.0, f64::max)
}

#[test]
fn a_mirrored_surface_gives_the_mirrored_panels() {
    let mesh = vault();
    let found = panels(&mesh, 250).unwrap();
    let image = panels(&mirrored(&mesh), 250).unwrap();
    let apart = apart(&mirrored(&found.mesh), &image.mesh);
    assert!(apart < 1e-6, "{apart}");
}

#[test]
fn a_moved_or_renumbered_surface_gives_the_same_panels() {
    let mesh = vault();
    let found = panels(&mesh, 250).unwrap();
    let frame = Random::new(7).frame();
    let moved = |mesh: &Mesh| {
        let moved =
            |&p: &[f64; 3]| (in_frame(frame, Vec3::from(p)) + Vec3::new(30.0, -50.0, 20.0)).into();
        Mesh { positions: mesh.positions.iter().map(moved).collect(), ..mesh.clone() }
    };
    let there = panels(&moved(&mesh), 250).unwrap();
    let off = apart(&moved(&found.mesh), &there.mesh);
    assert!(off < 1e-6, "{off}");
    // 23 by 17 vertices; 787 is coprime to their number and to that of the faces.
    let n = mesh.positions.len() as u32;
    let renamed = |v: u32| (v * 787) % n;
    let mut shuffled = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
    for v in 0..n {
        shuffled.positions[renamed(v) as usize] = mesh.positions[v as usize];
    }
    for k in 0..mesh.faces.len() {
        let face = mesh.faces.row((k * 787) % mesh.faces.len());
        shuffled.faces.push(&[face[1], face[2], face[0]].map(renamed));
    }
    let again = panels(&shuffled, 250).unwrap();
    assert_eq!(again.measures.irregular, found.measures.irregular);
    let off = apart(&found.mesh, &again.mesh);
    assert!(off < 1e-6, "{off}");
}

#[test]
fn a_groin_vault_is_covered_from_its_creases_to_its_corners() {
    let mesh = groin();
    let found = panels(&mesh, 300).unwrap();
    check(&mesh, &found);
    assert!(found.notes.is_empty() && found.level == 0, "{:?}", found.notes);
    // The creases are followed wherever they turn by more than a crease must.
    let on_crease = |v: u32| {
        let [x, y, _] = found.mesh.positions[v as usize];
        (x.abs() - y.abs()).abs() < 1e-9 && x.abs() > 1.5
    };
    let edges = Topology::new(&found.mesh);
    let along = edges.edges().iter().filter(|[a, b]| on_crease(*a) && on_crease(*b)).count();
    assert!(along >= 4 * 2, "{along}");
}

#[test]
fn where_neighbouring_panels_fold_is_named() {
    // A scan with details smaller than a panel.
    let Some(mesh) = shared::mesh("camelhead.off") else { return };
    let found = panels(&mesh, 500).unwrap();
    let reach = 4.0 * found.measures.edge.mean;
    let at = |v: u32| Vec3::from(found.mesh.positions[v as usize]);
    let places: Vec<Vec3<f64>> =
        found.notes.iter().flat_map(|note| &note.places).map(|&place| place.into()).collect();
    let (mut first, mut folds) = (BTreeMap::new(), 0);
    for face in found.mesh.faces.iter() {
        let normal = twice_vector_area(face.iter().map(|&v| at(v)));
        for k in 0..face.len() {
            let [a, b] = [face[k], face[(k + 1) % face.len()]];
            let Some(other) = first.insert([a.min(b), a.max(b)], normal) else { continue };
            if normal.dot(other) < 0.0 {
                folds += 1;
                let middle = (at(a) + at(b)) * 0.5;
                let is_named = places.iter().any(|&place| (place - middle).length() < reach);
                assert!(is_named, "a fold at {middle:?}, {places:?}");
            }
        }
    }
    assert!(folds > 0, "details are smaller than panels");
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
        let found = remesher.remesh(&options, "m", &mut |_| ()).unwrap();
        assert_eq!(found.mesh, with(&mesh, options).unwrap().mesh, "{options:?}");
    }
}
