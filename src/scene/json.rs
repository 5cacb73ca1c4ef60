//! The scene file, version 1, as JSON in and out; the README shows one.
//!
//! What is wrong is named by its JSON path, with what was found and what was expected. Here the
//! form is checked; whether indices and names fit the mesh is checked by `validate`.
//!
//! # The file
//!
//! Only `format`, `version` and `mesh` are required. Indices count from 0; a list of them is an array
//! or a string of ranges, `"0-199,240"`.
//!
//! | key | holds |
//! |---|---|
//! | "mesh" | `{ "file": PATH }`, relative to the scene, or `{ "positions", "faces", "curves", "tets", "groups" }` |
//! | "current" | `#V by 3`, where the iteration starts; without it, at rest |
//! | "sets" | `{ NAME: { "vertices": LIST } }` or `{ NAME: { "faces": LIST } }` |
//! | "constraints" | `kind`, `on`, `weight` (1), `enabled` (true), `name`, and the parameters of the kind |
//! | "handles" | `vertices`, `targets` (the rest positions), and `weight` (100) or `"fixed": true` |
//! | "weights" | `shape`, `close`, `smooth`: the weights of Eq. 13, by default 1, 0, 0 |
//! | "closeness" | `"to"`: `"surface"`, `"rest"` or `"none"`; `"weights"` of single sets; `"boundary"` to its curves |
//! | "smoothness" | `"of"`: `"surface"` or `"displacement"`; `"weighting"`: `"auto"`, `"uniform"`, `"cotangent"` (triangles) or `"polygon"` (any faces) |
//! | "solver" | `iterations`, `tolerance`, `accelerator` (`"quasi-newton"`, `"anderson"`, `"none"`), `window`, `mean_centring`, `monotone` |
//! | "lesson" | a text and goals |
//!
//! | on | one constraint for |
//! |---|---|
//! | "faces", "edges", "tets" | each face, edge, tetrahedron |
//! | "rings", "stars" | each vertex with its neighbours; with them in their order around it |
//! | "corners", "hinges" | each corner of a face, each edge with the corners opposite to it |
//! | "boundary", "strips" | each boundary loop, each strip of quads |
//! | "polylines" | each polyline of the file |
//! | "edge-lines" | on a mesh of quads each straight line of edges |
//! | "curves" | both; of two of which one runs along the other, the longer |
//! | { "each": "face", "in": NAME } | each of them in a set or group; "each": "group" is each group |
//! | { "each": "ring", "radius": 2 } | each, with so many rings of neighbours |
//! | { "set": NAME }, { "vertices": LIST } | all these vertices together |
//!
//! # The code
//!
//! | file | holds |
//! |---|---|
//! | `node` | the document as a tree, and typed access that names the place |
//! | `constraint` | one entry of the list of constraints |
//! | `closeness` | what vertices are kept close to |
//! | `indices` | index lists: arrays or strings of ranges |
//! | `lesson` | the exercise that a scene is, and the results that are handed in |
//! | `selector` | the forms of `on` |
//! | `inline_mesh` | a mesh inside the scene |
//! | `write` | JSON out |

mod closeness;
mod constraint;
mod indices;
mod inline_mesh;
mod lesson;
mod node;
mod selector;
mod write;

use super::{
    HANDLE_WEIGHT, HandleSpec, Hold, MeshSource, Scene, SceneError, Smoothness, SolverSettings,
    Weights,
};
use crate::constraint::{Set, Sets};
use crate::mesh::Point;
pub(super) use node::push_key;

pub(crate) use constraint::read as read_constraint;
pub(crate) use indices::read as read_indices;
pub(crate) use lesson::read as read_lesson;
pub(crate) use node::{At, Node};
pub(crate) use selector::read as read_selector;

/// The value of `format` in every scene file.
pub const FORMAT: &str = "shape-up-scene";
/// The version of the scene file that is read and written.
pub const VERSION: u32 = 1;

const KEYS: &[&str] = &[
    "format",
    "version",
    "title",
    "units",
    "up",
    "mesh",
    "current",
    "sets",
    "constraints",
    "handles",
    "weights",
    "closeness",
    "smoothness",
    "solver",
    "lesson",
];

impl Scene {
    /// Reads a scene file.
    ///
    /// # Errors
    /// When the text is not JSON (line and column), or not a scene of version 1 (the JSON path,
    /// what was found there and what was expected).
    pub fn from_json(text: &str) -> Result<Scene, SceneError> {
        let scene = read_scene(&At::root(&parse(text)?))?;
        scene.check_numbers()?;
        Ok(scene)
    }

    /// Writes the scene as a file: `mesh` goes inline where [`Scene::mesh`] is inline. What has its
    /// default value is left out. The same scene always gives the same text, and numbers read
    /// back to the same bits.
    pub fn to_json(&self, mesh: &crate::mesh::Mesh) -> String {
        write::scene(self, mesh)
    }
}

/// The document as a tree, with or without a byte order mark before it.
pub(crate) fn parse(text: &str) -> Result<Node, SceneError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    serde_json::from_str(text).map_err(|error| syntax_error(text, &error))
}

fn syntax_error(text: &str, error: &serde_json::Error) -> SceneError {
    let message = if text.trim().is_empty() {
        "the file is empty, expected a scene".to_owned()
    } else {
        let what = error.to_string();
        let what = what.split(" at line ").next().unwrap_or_default();
        format!("line {}, column {}: not JSON: {what}", error.line(), error.column())
    };
    SceneError { path: String::new(), message }
}

fn read_scene(at: &At<'_>) -> Result<Scene, SceneError> {
    // First of all: a later version may have keys that are unknown here.
    check_format(at, "a scene: an object", FORMAT, VERSION)?;
    at.only_keys(KEYS)?;

    let mut scene = Scene::new(read_mesh(&at.need("mesh", "{\"file\": ...} or a mesh")?)?);
    if let Some(title) = at.get("title") {
        scene.title = title.text("a text")?.to_owned();
    }
    if let Some(units) = at.get("units") {
        scene.units = units.text("a unit of length such as \"m\"")?.to_owned();
    }
    if let Some(up) = at.get("up") {
        scene.up = up.choice()?;
    }
    if let Some(current) = at.get("current") {
        scene.current = Some(read_points(&current)?);
    }
    if let Some(sets) = at.get("sets") {
        scene.sets = read_sets(&sets)?;
    }
    if let Some(constraints) = at.get("constraints") {
        let items = constraints.array("an array of constraints")?;
        scene.constraints = items.iter().map(constraint::read).collect::<Result<_, _>>()?;
    }
    if let Some(handles) = at.get("handles") {
        let items = handles.array("an array of handles")?;
        scene.handles = items.iter().map(read_handle).collect::<Result<_, _>>()?;
    }
    if let Some(weights) = at.get("weights") {
        scene.weights = read_weights(&weights)?;
    }
    if let Some(closeness) = at.get("closeness") {
        scene.closeness = closeness::read(&closeness)?;
    }
    if let Some(smoothness) = at.get("smoothness") {
        scene.smoothness = read_smoothness(&smoothness)?;
    }
    if let Some(solver) = at.get("solver") {
        scene.solver = read_solver(&solver)?;
    }
    if let Some(lesson) = at.get("lesson") {
        scene.lesson = Some(lesson::read(&lesson)?);
    }
    Ok(scene)
}

/// Checks that a document is of this `format`, and of the `version` that is read here; `what` says what it
/// would be.
fn check_format(at: &At<'_>, what: &str, format: &str, version: u32) -> Result<(), SceneError> {
    if !matches!(at.node, Node::Object(_)) {
        return Err(at.expected(what));
    }
    let found = at.need("format", &format!("\"format\": \"{format}\""))?;
    if found.node != &Node::Text(format.to_owned()) {
        return Err(found.expected(&format!("\"{format}\"")));
    }
    let found = at.need("version", &version.to_string())?;
    match found.whole(&version.to_string())? {
        own if own == version => Ok(()),
        later if later > version => Err(found.error(format!(
            "this is version {later} of {format}, this program reads version {version}: it needs a later program"
        ))),
        _ => Err(found.expected(&version.to_string())),
    }
}

fn read_mesh(at: &At<'_>) -> Result<MeshSource, SceneError> {
    let Some(file) = at.get("file") else {
        return Ok(MeshSource::Inline(Box::new(inline_mesh::read(at)?)));
    };
    at.only_keys(&["file"])?;
    match file.text("the path of a mesh file, relative to the scene")? {
        "" => Err(file.expected("the path of a mesh file, relative to the scene")),
        path => Ok(MeshSource::File(path.to_owned())),
    }
}

fn read_points(at: &At<'_>) -> Result<Vec<Point>, SceneError> {
    at.array("an array of points [x, y, z]")?.iter().map(At::point).collect()
}

fn read_sets(at: &At<'_>) -> Result<Sets, SceneError> {
    let mut sets = Sets::new();
    for (name, entry) in at.entries("an object of named sets")? {
        entry.only_keys(&["vertices", "faces"])?;
        let mut set = Set::default();
        if let Some(vertices) = entry.get("vertices") {
            set.vertices = indices::read(&vertices)?;
        }
        if let Some(faces) = entry.get("faces") {
            set.faces = indices::read(&faces)?;
        }
        if set.vertices.is_empty() && set.faces.is_empty() {
            return Err(entry.error("the set is empty, expected \"vertices\" or \"faces\""));
        }
        sets.insert(name.to_owned(), set);
    }
    Ok(sets)
}

fn read_handle(at: &At<'_>) -> Result<HandleSpec, SceneError> {
    at.only_keys(&["vertices", "targets", "weight", "fixed"])?;
    let list = at.need("vertices", "a list of indices")?;
    let vertices = indices::read(&list)?;
    if vertices.is_empty() {
        return Err(list.error("the list is empty, expected at least one vertex"));
    }
    let targets = match at.get("targets") {
        None => None,
        Some(targets) => {
            let points = read_points(&targets)?;
            if points.len() != vertices.len() {
                return Err(targets.error(format!(
                    "found {} targets, expected one for each of the {} vertices",
                    points.len(),
                    vertices.len()
                )));
            }
            Some(points)
        }
    };
    let fixed = at.get("fixed").map_or(Ok(false), |fixed| fixed.truth())?;
    let hold = match at.get("weight") {
        Some(weight) if fixed => {
            return Err(weight.error("a fixed handle is met exactly and takes no weight"));
        }
        Some(weight) => Hold::Soft { weight: weight.number("a number above 0")? },
        None if fixed => Hold::Fixed,
        None => Hold::Soft { weight: HANDLE_WEIGHT },
    };
    Ok(HandleSpec { vertices, targets, hold })
}

fn read_weights(at: &At<'_>) -> Result<Weights, SceneError> {
    at.only_keys(&["shape", "close", "smooth"])?;
    let mut weights = Weights::default();
    for (key, weight) in [
        ("shape", &mut weights.shape),
        ("close", &mut weights.close),
        ("smooth", &mut weights.smooth),
    ] {
        if let Some(value) = at.get(key) {
            *weight = value.number("a number from 0")?;
        }
    }
    Ok(weights)
}

fn read_smoothness(at: &At<'_>) -> Result<Smoothness, SceneError> {
    at.only_keys(&["of", "weighting"])?;
    let mut smoothness = Smoothness::default();
    if let Some(of) = at.get("of") {
        smoothness.of = of.choice()?;
    }
    if let Some(weighting) = at.get("weighting") {
        smoothness.weighting = weighting.choice()?;
    }
    Ok(smoothness)
}

fn read_solver(at: &At<'_>) -> Result<SolverSettings, SceneError> {
    at.only_keys(&[
        "iterations",
        "tolerance",
        "accelerator",
        "window",
        "mean_centring",
        "monotone",
        "factorization",
    ])?;
    let mut solver = SolverSettings::default();
    if let Some(iterations) = at.get("iterations") {
        solver.iterations = iterations.whole("a whole number from 0")?;
    }
    if let Some(tolerance) = at.get("tolerance") {
        solver.tolerance = tolerance.number("a number from 0")?;
    }
    if let Some(accelerator) = at.get("accelerator") {
        solver.accelerator = accelerator.choice()?;
    }
    if let Some(window) = at.get("window") {
        solver.window = window.whole("a whole number from 0")?;
    }
    if let Some(mean_centring) = at.get("mean_centring") {
        solver.mean_centring = mean_centring.truth()?;
    }
    if let Some(monotone) = at.get("monotone") {
        solver.monotone = monotone.truth()?;
    }
    if let Some(factorization) = at.get("factorization") {
        solver.factorization = factorization.choice()?;
    }
    Ok(solver)
}
