//! The programs in `tests/library`, which show how the crate is used as a library: each does what it
//! says, and is short.

#[path = "library/build.rs"]
mod build;
#[path = "library/constrain.rs"]
mod constrain;
#[path = "library/drag.rs"]
mod drag;
#[path = "library/measure.rs"]
mod measure;
#[path = "library/press.rs"]
mod press;
#[path = "library/remesh.rs"]
mod remesh;

use crate::support::meshes::wavy;
use shape_up::mesh::{Measures, Mesh, diagonal, read, write_obj};
use std::fs::read_to_string;
use std::path::Path;

/// More lines than an example has.
const LONG: usize = 40;

/// A wavy roof as an OBJ file.
fn roof() -> Vec<u8> {
    let mesh = wavy(8, 6);
    write_obj(&mesh, &mesh.positions).into_bytes()
}

/// The largest distance of the corners of a face of an OBJ file from a circle.
fn off_circle(text: &str) -> f64 {
    let Mesh { positions, faces, .. } = read("out.obj", text.as_bytes()).unwrap().mesh;
    Measures::new(&positions, &faces, diagonal(&positions)).circularity.max_distance
}

#[test]
fn a_file_is_measured() {
    let said = measure::measure("roof.obj", &roof()).unwrap();
    assert!(said.starts_with("48 faces: up to 0.0") && said.ends_with(" from circular"), "{said}");
    let refused = measure::measure("roof.obj", b"f 1 2 3\n").unwrap_err().to_string();
    assert!(refused.starts_with("roof.obj: the file has no vertices"), "{refused}");
}

#[test]
fn constraints_of_a_scene_are_solved() {
    let (text, worst) = constrain::constrain("roof.obj", &roof()).unwrap();
    let before = off_circle(std::str::from_utf8(&roof()).unwrap());
    assert!(worst < 0.02 && off_circle(&text) < 0.2 * before, "{worst}");
}

#[test]
fn a_press_ends_with_a_verdict() {
    let (text, verdict) = press::press("roof.obj", &roof()).unwrap();
    assert!(verdict.contains("All 48 panels are circular within 1 mm."), "{verdict}");
    assert!(off_circle(&text) <= 0.001, "{verdict}");
}

#[test]
fn a_dragged_shape_is_exact_when_it_is_let_go() {
    let (text, worst) = drag::drag("roof.obj", &roof()).unwrap();
    assert!(worst < 1e-9 && off_circle(&text) < 1e-9, "{worst}");
    let corner = |text: &str| read("out.obj", text.as_bytes()).unwrap().mesh.positions[0][2];
    assert!(corner(&text) > corner(std::str::from_utf8(&roof()).unwrap()) + 0.2);
}

#[test]
fn a_surface_gets_new_panels() {
    let (text, _) = remesh::panels("roof.obj", &roof(), 60).unwrap();
    let mesh = read("out.obj", text.as_bytes()).unwrap().mesh;
    assert!((30..120).contains(&mesh.faces.len()), "{}", mesh.faces.len());
    assert!(mesh.faces.iter().all(|face| face.len() == 4));
}

#[test]
fn panels_become_sheets() {
    let files = build::parts("roof.obj", &roof()).unwrap();
    let names: Vec<_> = files.iter().map(|file| &*file.name).collect();
    for name in ["sheet-01.svg", "sheet-01.dxf", "panels.csv"] {
        assert!(names.contains(&name), "{names:?}");
    }
}

#[test]
fn each_is_short() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library");
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        let lines = read_to_string(&path).unwrap().lines().count();
        assert!(lines < LONG, "{} has {lines} lines", path.display());
    }
}
