//! `shape-up examples`: lists the examples, or writes their scenes and models.

use super::{Failure, output};
use serde::Serialize;
use shape_up::experiment::Experiment;
use shape_up::mesh::{write_medit, write_obj};
use shape_up::scene::examples::EXAMPLES;
use std::path::{Path, PathBuf};

/// One entry of `index.json`, from which the page makes its list.
#[derive(Serialize)]
struct Entry {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    statement: &'static str,
    scene: String,
    mesh: String,
    /// The comparison that can be run on it.
    experiment: Option<&'static Experiment>,
}

/// One line per example.
pub(super) fn list() -> Result<(), Failure> {
    let line = |example: &shape_up::scene::examples::Example| {
        format!("{:<20} {}. {}\n", example.id, example.title, example.summary)
    };
    output::print(&EXAMPLES.iter().map(line).collect::<String>())
}

/// Writes `<id>.shapeup.json` and the mesh of each example, and `index.json`. Meshes are OBJ, those
/// with tetrahedra Medit.
pub(super) fn write(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| {
        Failure::Input(format!(
            "{}: cannot be made: {error}, expected the name of a folder",
            folder.display()
        ))
    })?;
    let mut files: Vec<(PathBuf, String)> = Vec::new();
    for example in EXAMPLES {
        let (scene, mesh) = example.build();
        let text = match mesh.tets.is_empty() {
            true => write_obj(&mesh, &mesh.positions),
            false => write_medit(&mesh),
        };
        files.push((folder.join(example.file()), scene.to_json(&mesh)));
        files.push((folder.join(example.mesh_file()), text));
    }
    let index: Vec<_> = EXAMPLES
        .iter()
        .map(|e| Entry {
            id: e.id,
            title: e.title,
            summary: e.summary,
            statement: e.statement,
            scene: e.file(),
            mesh: e.mesh_file(),
            experiment: Experiment::of(e.id),
        })
        .collect();
    let index = serde_json::to_string_pretty(&index).expect("entries are plain text");
    files.push((folder.join("index.json"), index + "\n"));
    let files: Vec<_> = files.iter().map(|(path, text)| (path.as_path(), text.clone())).collect();
    output::write(&files)?;
    let names: Vec<_> = files.iter().map(|(path, _)| format!("{}\n", path.display())).collect();
    output::print(&names.concat())
}
