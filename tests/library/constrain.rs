//! Constraints of a scene, solved: the corners of each face on a circle, the boundary on one sphere.
//!
//! `cargo run --release --example constrain -- roof.obj out.obj`

use shape_up::mesh::read;
use shape_up::scene::Scene;
use shape_up::session::Session;
use std::error::Error;

/// The scene file, whose keys `src/scene/json` explains.
const SCENE: &str = r#"{
    "format": "shape-up-scene", "version": 1, "mesh": { "file": "given by the program" },
    "constraints": [
        { "kind": "circle", "on": "faces", "weight": 1 },
        { "kind": "sphere", "on": "boundary", "weight": 0.5 }
    ],
    "closeness": { "to": "rest" }, "weights": { "shape": 100, "close": 1, "smooth": 1 }
}"#;

/// Returns the solved mesh as an OBJ file, and the largest distance of a vertex from its shapes.
pub(crate) fn constrain(name: &str, bytes: &[u8]) -> Result<(String, f64), Box<dyn Error>> {
    let mesh = read(name, bytes)?.mesh;
    let mut session = Session::open(Scene::from_json(SCENE)?, mesh)?;
    session.solve(false)?;
    Ok((session.obj(), session.worst_distance()))
}

#[allow(dead_code, reason = "the tests call what it calls")]
fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let [name, out] = &names[..] else { return Err("expected two names of files".into()) };
    let (text, worst) = constrain(name, &std::fs::read(name)?)?;
    std::fs::write(out, text)?;
    println!("{out}: every vertex within {worst} of its shapes");
    Ok(())
}
