//! New panels along the lines of curvature of a surface.
//!
//! `cargo run --release --example remesh -- scan.obj out.obj`

use shape_up::mesh::{read, write_obj};
use shape_up::quads::{MapOptions, PanelSize, remesh};
use std::error::Error;

/// Returns about `count` quads that cover the surface as an OBJ file, and what there is to know of
/// them: places that they do not follow, and irregular vertices.
pub(crate) fn panels(
    name: &str,
    bytes: &[u8],
    count: usize,
) -> Result<(String, String), Box<dyn Error>> {
    let mesh = read(name, bytes)?.mesh;
    let options = MapOptions::of_size(PanelSize::Count(count));
    // The observer is told what is being done.
    let found = remesh(&mesh, &options, "m", &mut |_stage| ())?;
    let notes: Vec<&str> = found.notes.iter().map(|note| note.words.as_str()).collect();
    Ok((write_obj(&found.mesh, &found.mesh.positions), notes.join(" ")))
}

#[allow(dead_code, reason = "the tests call what it calls")]
fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let [name, out] = &names[..] else { return Err("expected two names of files".into()) };
    let (text, notes) = panels(name, &std::fs::read(name)?, 500)?;
    std::fs::write(out, text)?;
    println!("{out}: {notes}");
    Ok(())
}
