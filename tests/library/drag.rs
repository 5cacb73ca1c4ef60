//! A corner is dragged while the panels stay near circles, and lie on them when it is let go.
//!
//! `cargo run --release --example drag -- roof.obj out.obj`

use shape_up::mesh::{diagonal, read};
use shape_up::scene::Scene;
use shape_up::session::{DragPhase, Session};
use shape_up::solve::Require;
use std::error::Error;

/// Makes all panels exact circles, and lifts the first vertex by a tenth of the size of the mesh.
/// Returns the mesh as an OBJ file, and the largest distance of a corner from the circle of its panel.
pub(crate) fn drag(name: &str, bytes: &[u8]) -> Result<(String, f64), Box<dyn Error>> {
    let mesh = read(name, bytes)?.mesh;
    let mut scene = Scene::opened(name);
    scene.request_panels("circle", Require::Exact, &mesh)?;
    let mut session = Session::open(scene, mesh)?;
    session.solve(false)?;
    let (at @ [x, y, z], size) = (session.positions()[0], diagonal(&session.positions()));
    session.drag_through(DragPhase::Make, &[0], &[at])?;
    for part in 1..=10 {
        let to = [x, y, z + 0.01 * size * f64::from(part)];
        session.drag_through(DragPhase::Move, &[0], &[to])?;
        session.step()?;
    }
    session.drag_through(DragPhase::End, &[0], &[])?;
    while !session.step()?.ended {}
    Ok((session.obj(), session.measures().circularity.max_distance))
}

#[allow(dead_code, reason = "the tests call what it calls")]
fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let [name, out] = &names[..] else { return Err("expected two names of files".into()) };
    let (text, worst) = drag(name, &std::fs::read(name)?)?;
    std::fs::write(out, text)?;
    println!("{out}: every corner within {worst} of a circle");
    Ok(())
}
