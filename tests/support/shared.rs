//! Material beside the project, in `../shared`: foreign meshes, and results of an independent
//! implementation. A clone of the repository alone has none: there, tests print that they skip, which
//! `.scripts/count.mjs` counts.

use serde_json::Value;
use shape_up::math::Vec3;
use shape_up::mesh::{Mesh, read};
use std::path::{Path, PathBuf};

/// Path of a file or folder of `../shared`, which must be there if the folder of its kind is, such as
/// `meshes`; without that folder prints a line and returns `None`.
pub(crate) fn path(name: &str) -> Option<PathBuf> {
    let shared = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let kind = name.split('/').next().unwrap_or_default();
    if !shared.join(kind).exists() {
        println!("skipped: there is no ../shared, or no {kind} in it");
        return None;
    }
    let path = shared.join(name);
    assert!(path.exists(), "there is no {}", path.display());
    Some(path)
}

fn bytes(name: &str) -> Option<Vec<u8>> {
    Some(std::fs::read(path(name)?).expect("the file can be read"))
}

/// A mesh of `../shared/meshes`.
pub(crate) fn mesh(file: &str) -> Option<Mesh> {
    read_in("meshes", file)
}

/// A mesh of `../shared/cases`.
pub(crate) fn case(file: &str) -> Option<Mesh> {
    read_in("cases", file)
}

fn read_in(folder: &str, file: &str) -> Option<Mesh> {
    let bytes = bytes(&format!("{folder}/{file}"))?;
    Some(read(file, &bytes).expect("the meshes are valid").mesh)
}

/// All polygon meshes of a folder of `../shared` that can be read, by name.
pub(crate) fn meshes_in(folder: &str) -> Vec<(String, Mesh)> {
    let Some(path) = path(folder) else { return Vec::new() };
    let files = std::fs::read_dir(path).expect("the folder can be read");
    let mut names: Vec<String> =
        files.flatten().filter_map(|file| file.file_name().into_string().ok()).collect();
    names.retain(|name| name.ends_with(".obj") || name.ends_with(".off"));
    names.sort();
    let opened = names.into_iter().filter_map(|name| {
        let read = read(&name, &bytes(&format!("{folder}/{name}"))?).ok()?;
        Some((name, read.mesh))
    });
    opened.collect()
}

/// Expected results of the case `name`, for the mesh scaled to a bounding sphere of diameter 1; see
/// [`diameter`].
pub(crate) fn expected(name: &str) -> Option<Value> {
    let bytes = bytes(&format!("expected/{name}.json"))?;
    Some(serde_json::from_slice(&bytes).expect("it is JSON"))
}

/// Diameter of the bounding sphere, accurate to 2e-6 of it, by which the independent implementation
/// divided the mesh: a number, part of a sentence, or from the volume before and after.
pub(crate) fn diameter(expected: &Value, mesh: &Mesh) -> f64 {
    if let Some(diameter) = expected["diameter"].as_f64() {
        return diameter;
    }
    if let Some(volume) = expected["volume_before"].as_f64() {
        let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
        let volumes = mesh
            .tets
            .iter()
            .map(|&[a, b, c, d]| (at(b) - at(a)).dot((at(c) - at(a)).cross(at(d) - at(a))) / 6.0);
        return (volumes.sum::<f64>() / volume).cbrt();
    }
    let sentence = expected["normalised"].as_str().expect("a sentence");
    let (_, rest) = sentence.split_once("original diameter ").expect("the diameter");
    let number = rest.split([' ', ',']).next().expect("there is a number");
    number.parse().expect("it is a number")
}
