//! The material beside the project, in `../shared`: meshes that nobody here made, and what an
//! independent implementation found. Where it is absent, tests print that they skip.
#![allow(dead_code, reason = "each test file uses some of these")]

use serde_json::Value;
use shape_up::mesh::{Mesh, read};
use std::path::{Path, PathBuf};

/// The path of a file or folder; none, and a line that says so, where it is absent.
pub(crate) fn path(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared").join(name);
    if path.exists() {
        return Some(path);
    }
    println!("skipped: there is no {}", path.display());
    None
}

fn bytes(name: &str) -> Option<Vec<u8>> {
    Some(std::fs::read(path(name)?).expect("the file can be read"))
}

/// A mesh of `../shared/meshes`.
pub(crate) fn mesh(file: &str) -> Option<Mesh> {
    let bytes = bytes(&format!("meshes/{file}"))?;
    Some(read(file, &bytes).expect("the meshes are valid").mesh)
}

/// The file of `../shared/expected` for the case `name`.
pub(crate) fn case(name: &str) -> Option<Value> {
    let bytes = bytes(&format!("expected/{name}.json"))?;
    Some(serde_json::from_slice(&bytes).expect("it is JSON"))
}

/// What is expected in the case `name`, for the mesh scaled so that its bounding sphere has
/// diameter 1; and that diameter before.
pub(crate) fn expected(name: &str) -> Option<(Value, f64)> {
    let expected = case(name)?;
    let diameter = expected["diameter"].as_f64().unwrap_or_else(|| {
        let sentence = expected["normalised"].as_str().expect("a sentence");
        let (_, rest) = sentence.split_once("original diameter ").expect("the diameter");
        let number = rest.split([' ', ',']).next().expect("there is a number");
        number.parse().expect("it is a number")
    });
    Some((expected, diameter))
}
