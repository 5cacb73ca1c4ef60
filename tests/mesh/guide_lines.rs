//! Guide lines, the outline of a site and stray vertices beside a surface: nothing that is said of the
//! surface hangs on them.

use super::operations::{Picked, apply, with_vertices};
use crate::support::meshes::wavy;
use shape_up::mesh::{
    Measures, Mesh, Scheme, Subdivision, Topology, curvatures, gauss_curvature, quasi_conformal,
    smoothed_area, stars,
};
use shape_up::scene::{Scene, UnitsAndUp};
use shape_up::session::{Session, tolerance_of};

/// The same with a line from an interior vertex far down, bracing along the diagonals of two panels, the
/// outline of a site, and a vertex of nothing.
fn with_guides(surface: &Mesh) -> Mesh {
    let mut mesh = surface.clone();
    let first = mesh.positions.len() as u32;
    let outline = [[-900.0, -900.0, 0.0], [900.0, -900.0, 0.0], [900.0, 900.0, 0.0]];
    mesh.positions.extend([[3.0, 2.0, -40.0], [0.0, 9e6, 0.0]]);
    mesh.positions.extend(outline);
    mesh.curves.push(&[16, first]);
    mesh.curves.push(&[8, 16, 24]);
    mesh.curves.push(&[first + 2, first + 3, first + 4]);
    mesh
}

#[test]
fn nothing_that_is_said_of_a_surface_hangs_on_the_lines_beside_it() {
    let surface = wavy(6, 4);
    let beside = with_guides(&surface);
    let measured = |mesh: &Mesh| {
        let topology = Topology::new(mesh);
        let at = &mesh.positions;
        let uv: Vec<[f64; 2]> = at.iter().map(|&[x, y, _]| [x, y]).collect();
        let count = surface.positions.len();
        // Beside is what has no curvature.
        let gauss = gauss_curvature(at, mesh, &topology);
        let session = Session::open(Scene::opened("own.obj"), mesh.clone()).expect("it opens");
        (
            [mesh.size(), topology.mean_edge(at), tolerance_of(mesh)],
            Measures::clone(&session.measures()),
            smoothed_area(mesh, &topology, at),
            curvatures(at, &mesh.faces, &topology)[..count].to_vec(),
            gauss[..count].iter().map(|x| x.to_bits()).collect::<Vec<u64>>(),
            stars(mesh, &topology),
            topology.ring(16, 2),
            quasi_conformal(at, &uv, &mesh.faces, &[]).quasi_conformal.mean,
            UnitsAndUp::guess_units(mesh),
        )
    };
    assert_eq!(measured(&beside), measured(&surface));
}

#[test]
fn a_surface_is_refined_alike_with_lines_at_its_vertices() {
    let surface = wavy(6, 4);
    let refined = |mesh: &Mesh| {
        let once = Subdivision { scheme: Scheme::CatmullClark, levels: 1, keep: 75.0 };
        let refined = once.apply(mesh, &Topology::new(mesh)).expect("it has faces").mesh;
        // The vertices of the surface, and the centres of its faces.
        let count = refined.positions.len();
        let centres = refined.positions[count - mesh.faces.len()..].to_vec();
        (refined.positions[..surface.positions.len()].to_vec(), centres)
    };
    assert_eq!(refined(&with_guides(&surface)), refined(&surface));
}

#[test]
fn without_faces_tetrahedra_decide_and_without_these_curves() {
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [9.0; 3]];
    let mut mesh = Mesh { positions, ..Mesh::default() };
    let found = |mesh: &Mesh| (mesh.size(), Topology::new(mesh).mean_edge(&mesh.positions));
    assert_eq!(found(&mesh).1, 0.0);
    let of_all = mesh.size();
    mesh.curves.push(&[3, 4]);
    let of_curve = found(&mesh);
    assert!(of_curve.0 < of_all && (of_curve.0 - of_curve.1).abs() < 1e-12);
    mesh.tets.push([0, 1, 2, 3]);
    assert!((found(&mesh).1 - (3.0 + 3.0 * 2_f64.sqrt()) / 6.0).abs() < 1e-15);
    mesh.faces.push(&[0, 1, 2]);
    assert!((found(&mesh).1 - (2.0 + 2_f64.sqrt()) / 3.0).abs() < 1e-15);
    assert!((mesh.size() - 2_f64.sqrt()).abs() < 1e-15);
}

#[test]
fn an_operation_without_effect_is_refused_beside_a_line_too() {
    let triangles = apply(&wavy(2, 2), "triangles", None, &Picked::default());
    let mut mesh = triangles.expect("it has quads").mesh;
    let first = mesh.positions.len() as u32;
    mesh.positions.extend([[0.0, 0.0, 5.0], [1.0, 0.0, 5.0]]);
    mesh.curves.push(&[first, first + 1]);
    let refused = apply(&mesh, "triangles", None, &Picked::default());
    let refused = refused.expect_err("all faces are triangles").to_string();
    assert_eq!(refused, "this needs a face with more than three corners");
}

/// A brace was taken for an edge of faces: panels were not cut along it, and to remove the "strip" of a
/// column pulled the roof to its foot.
#[test]
fn an_edit_of_faces_does_not_take_a_line_for_their_edge() {
    let surface = wavy(6, 4);
    let mut beside = with_guides(&surface);
    beside.curves.push(&[9, 15]);
    let nothing = Picked::default();
    for (id, picked) in [("triangles", &nothing), ("split-face", &with_vertices(&[8, 16]))] {
        let faces = |mesh: &Mesh| apply(mesh, id, None, picked).expect(id).mesh.faces;
        assert_eq!(faces(&beside), faces(&surface), "{id}");
    }
    let column = with_vertices(&[16, surface.positions.len() as u32]);
    for id in ["insert-strip", "remove-strip"] {
        let refused = apply(&beside, id, None, &column).expect_err(id).to_string();
        assert_eq!(refused, "this needs an edge whose two ends are selected");
    }
}
