//! Panels as parts on sheets to be cut.
//!
//! `cargo run --release --example build -- roof.obj parts`

use shape_up::fabricate::{Build, BuildFile, Stand, unit_of};
use shape_up::mesh::read;
use shape_up::scene::BuildSettings;
use std::error::Error;
use std::path::Path;

/// Returns the drawings and tables of a model whose unit is the metre, at 1:50 on card.
pub(crate) fn parts(name: &str, bytes: &[u8]) -> Result<Vec<BuildFile>, Box<dyn Error>> {
    let mesh = read(name, bytes)?.mesh;
    let settings = BuildSettings { scale: 50.0, ..BuildSettings::default() };
    let build = Build::new(&mesh, &settings, unit_of("m")?, &Stand::default())?;
    Ok(build.files(true))
}

#[allow(dead_code, reason = "the tests call what it calls")]
fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let [name, folder] = &names[..] else { return Err("expected a file and a folder".into()) };
    std::fs::create_dir_all(folder)?;
    for file in parts(name, &std::fs::read(name)?)? {
        std::fs::write(Path::new(folder).join(&file.name), file.bytes)?;
        println!("{}", file.name);
    }
    Ok(())
}
