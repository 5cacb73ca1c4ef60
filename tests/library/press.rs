//! What a press on "Make panels circular" does: the search for a good shape within the tolerance.
//!
//! `cargo run --release --example press -- roof.obj out.obj`

use shape_up::mesh::read;
use shape_up::scene::Scene;
use shape_up::session::Session;
use std::error::Error;

/// Returns the mesh as an OBJ file, and the verdict on it.
pub(crate) fn press(name: &str, bytes: &[u8]) -> Result<(String, String), Box<dyn Error>> {
    let mesh = read(name, bytes)?.mesh;
    let scene = Scene { units: "m".to_owned(), ..Scene::opened(name) };
    let mut session = Session::open(scene, mesh)?;
    let tolerance = session.tolerance();
    session.solve_as_pressed(Some("circle"), tolerance, false)?;
    let verdict = session.verdict(tolerance).ok_or("there are no panels")?;
    Ok((session.obj(), session.verdict_words(&verdict).full()))
}

#[allow(dead_code, reason = "the tests call what it calls")]
fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let [name, out] = &names[..] else { return Err("expected two names of files".into()) };
    let (text, verdict) = press(name, &std::fs::read(name)?)?;
    std::fs::write(out, text)?;
    println!("{verdict}");
    Ok(())
}
