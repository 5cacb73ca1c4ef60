//! How far the panels of a mesh file are from flat and from circular.
//!
//! `cargo run --release --example measure -- roof.obj`

use shape_up::mesh::{Measures, diagonal, read};
use std::error::Error;

/// Returns the sentence on a file of this name and these contents.
pub(crate) fn measure(name: &str, bytes: &[u8]) -> Result<String, Box<dyn Error>> {
    let mesh = read(name, bytes)?.mesh;
    let found = Measures::new(&mesh.positions, &mesh.faces, diagonal(&mesh.positions));
    Ok(format!(
        "{} faces: up to {} from flat, up to {} from circular",
        mesh.faces.len(),
        found.planarity.max_distance,
        found.circularity.max_distance
    ))
}

#[allow(dead_code, reason = "the tests call what it calls")]
fn main() -> Result<(), Box<dyn Error>> {
    let name = std::env::args().nth(1).ok_or("expected the name of a mesh file")?;
    println!("{}", measure(&name, &std::fs::read(&name)?)?);
    Ok(())
}
