//! The files of the examples, which the command line and the build of the page write, and the
//! engine of the page makes again: their scenes and meshes, and the list from which the page builds
//! its menu and the gallery its cards.

use super::declaration::Example;
use super::scene::EXAMPLES;
use crate::constraint::Info;
use crate::mesh::{Mesh, write_medit, write_obj};
use crate::scene::Scene;
use crate::session::{GoalWords, goals_in_words};
use serde::Serialize;

/// One entry of `index.json`.
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
    /// Plots that hosts offer.
    plots: &'static [Plot],
    /// The task of a lesson.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    goals: Vec<GoalWords<'a>>,
}

/// The label of a button, and the id of the plot that it opens.
#[derive(Serialize)]
struct Plot {
    label: &'static str,
    plot: &'static str,
}

const ANGLES: &[Plot] = &[Plot { label: "Angles before and after", plot: "angles" }];

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
        let lesson = scene.lesson.as_ref();
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
            plots: if example.id == "fig-07-quality" { ANGLES } else { &[] },
            goals: lesson.map(|lesson| goals_in_words(lesson, &scene.units)).unwrap_or_default(),
        }
    }
}

/// Returns the text of an example's scene or mesh by the name of the file; `None` if no example has
/// a file of that name. Meshes are OBJ, or Medit if they have tetrahedra.
pub fn example_file(name: &str) -> Option<String> {
    let example = EXAMPLES.iter().find(|one| name == one.file() || name == one.mesh_file())?;
    let (scene, mesh) = example.build();
    Some(if name == example.file() { scene.to_json(&mesh) } else { mesh_text(&mesh) })
}

fn mesh_text(mesh: &Mesh) -> String {
    match mesh.tets.is_empty() {
        true => write_obj(mesh, &mesh.positions),
        false => write_medit(mesh),
    }
}

/// Returns the names and texts of all files: `<id>.shapeup.json` and the mesh of each example, and
/// `index.json`.
pub fn example_files() -> Vec<(String, String)> {
    let built: Vec<_> = EXAMPLES.iter().map(|example| (example, example.build())).collect();
    let mut files = Vec::new();
    let mut index = Vec::new();
    for (example, (scene, mesh)) in &built {
        files.push((example.file(), scene.to_json(mesh)));
        files.push((example.mesh_file(), mesh_text(mesh)));
        index.push(Entry::new(example, scene, mesh));
    }
    let index = serde_json::to_string_pretty(&index).expect("it is plain data with finite numbers");
    files.push(("index.json".to_owned(), index + "\n"));
    files
}
