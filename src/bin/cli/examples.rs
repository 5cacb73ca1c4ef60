//! `shape-up examples`: lists the examples, or writes their scenes and models.

use super::folder::MadeFolders;
use super::{Failure, output};
use serde::Serialize;
use shape_up::constraint::Info;
use shape_up::example::{EXAMPLES, Example, Suggestion, suggestions};
use shape_up::experiment::Experiment;
use shape_up::mesh::{Mesh, write_medit, write_obj};
use shape_up::scene::Scene;
use shape_up::session::{GoalWords, goals_in_words};
use std::path::{Path, PathBuf};

/// One entry of `index.json`, from which the page builds its list and the gallery its cards.
#[derive(Serialize)]
struct Entry<'a> {
    id: &'static str,
    /// The figure of the paper that it reproduces, if any.
    figure: Option<u32>,
    title: &'static str,
    summary: &'static str,
    statement: &'static str,
    scene: String,
    mesh: String,
    /// Counts of the mesh.
    vertices: usize,
    faces: usize,
    tets: usize,
    /// The unit of its coordinates.
    units: &'a str,
    /// The distinct kinds of its constraints.
    kinds: Vec<KindName>,
    /// `lambda_shape`, `lambda_close` and `lambda_smooth` of Eq. 13.
    weights: [f64; 3],
    /// The experiment of the example.
    experiment: Option<&'static Experiment>,
    /// The description of the example.
    suggestions: &'static [Suggestion],
    /// The task of a lesson.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    goals: Vec<GoalWords<'a>>,
}

#[derive(Serialize, PartialEq)]
struct KindName {
    id: &'static str,
    label: &'static str,
}

impl<'a> Entry<'a> {
    fn new(example: &Example, scene: &'a Scene, mesh: &Mesh) -> Entry<'a> {
        let mut kinds = Vec::new();
        for spec in &scene.constraints {
            let Info { id, label, .. } = *spec.kind.info();
            let kind = KindName { id, label };
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
        }
        let number = example.id.strip_prefix("fig-").and_then(|rest| rest.split('-').next());
        Entry {
            id: example.id,
            figure: number.and_then(|digits| digits.parse().ok()),
            title: example.title,
            summary: example.summary,
            statement: example.statement,
            scene: example.file(),
            mesh: example.mesh_file(),
            vertices: mesh.positions.len(),
            faces: mesh.faces.len(),
            tets: mesh.tets.len(),
            units: &scene.units,
            kinds,
            weights: [scene.weights.shape, scene.weights.close, scene.weights.smooth],
            experiment: Experiment::of(example.id),
            suggestions: suggestions(example.id),
            goals: scene.lesson.as_ref().map(goals_in_words).unwrap_or_default(),
        }
    }
}

/// Prints one line per example.
pub(super) fn list() -> Result<(), Failure> {
    let line =
        |example: &Example| format!("{:<20} {}. {}\n", example.id, example.title, example.summary);
    output::print(&EXAMPLES.iter().map(line).collect::<String>())
}

/// Writes `<id>.shapeup.json` and the mesh of each example, and `index.json`. Meshes are OBJ, or
/// Medit if they have tetrahedra.
pub(super) fn write(folder: &Path) -> Result<(), Failure> {
    let _made = MadeFolders::make(folder)?;
    let mut files: Vec<(PathBuf, String)> = Vec::new();
    let built: Vec<_> = EXAMPLES.iter().map(|example| (example, example.build())).collect();
    let mut index = Vec::new();
    for (example, (scene, mesh)) in &built {
        let text = match mesh.tets.is_empty() {
            true => write_obj(mesh, &mesh.positions),
            false => write_medit(mesh),
        };
        files.push((folder.join(example.file()), scene.to_json(mesh)));
        files.push((folder.join(example.mesh_file()), text));
        index.push(Entry::new(example, scene, mesh));
    }
    files.push((folder.join("index.json"), output::json(&index)));
    output::write(&files)?;
    let names: Vec<_> = files.iter().map(|(path, _)| format!("{}\n", path.display())).collect();
    output::print(&names.concat())
}
