//! Reads a scene.

use super::node::{JsonCursor, read_points};
use super::parse::{check_format, parse};
use super::{closeness, constraint, handle, indices, inline_mesh, lesson};
use crate::constraint::{Set, Sets};
use crate::scene::{MeshSource, Scene, SceneError, Smoothness, SolverSettings, Weights};

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
        let scene = read_scene(&JsonCursor::root(&parse(text)?))?;
        scene.check_numbers()?;
        Ok(scene)
    }
}

fn read_scene(at: &JsonCursor<'_>) -> Result<Scene, SceneError> {
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
        scene.handles = items.iter().map(handle::read).collect::<Result<_, _>>()?;
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

fn read_mesh(at: &JsonCursor<'_>) -> Result<MeshSource, SceneError> {
    let Some(file) = at.get("file") else {
        return Ok(MeshSource::Inline(Box::new(inline_mesh::read(at)?)));
    };
    at.only_keys(&["file"])?;
    match file.text("the path of a mesh file, relative to the scene")? {
        "" => Err(file.expected("the path of a mesh file, relative to the scene")),
        path => Ok(MeshSource::File(path.to_owned())),
    }
}

fn read_sets(at: &JsonCursor<'_>) -> Result<Sets, SceneError> {
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

fn read_weights(at: &JsonCursor<'_>) -> Result<Weights, SceneError> {
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

fn read_smoothness(at: &JsonCursor<'_>) -> Result<Smoothness, SceneError> {
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

fn read_solver(at: &JsonCursor<'_>) -> Result<SolverSettings, SceneError> {
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
