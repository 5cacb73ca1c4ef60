//! Writing the scene as JSON: one line per constraint, handle and set, without default values.

use super::file::{FORMAT, VERSION};
use super::text::{field, lines, number, object, point, rows, text};
use super::{closeness, constraint, handle, lesson, mesh as inline_mesh};
use crate::constraint::Set;
use crate::fabricate::BuildSettings;
use crate::json::indices;
use crate::mesh::Mesh;
use crate::scene::{MeshSource, NamedEnum, Pose, Scene, Slide, Up, Variants};
use serde_json::{Map, Value};

impl Scene {
    /// Returns the scene as the text of a file; `mesh` is written inline if [`Scene::mesh`] is
    /// inline. Default values are left out. The same scene always gives the same text, and numbers
    /// read back to the same bits.
    pub fn to_json(&self, mesh: &Mesh) -> String {
        write(self, mesh)
    }
}

fn write(scene: &Scene, mesh: &Mesh) -> String {
    let mut fields = vec![field("format", text(FORMAT)), field("version", VERSION.to_string())];
    if !scene.title.is_empty() {
        fields.push(field("title", text(&scene.title)));
    }
    if !scene.units.is_empty() {
        fields.push(field("units", text(&scene.units)));
    }
    if scene.up != Up::Z {
        fields.push(field("up", text(scene.up.word())));
    }
    fields.push(field(
        "mesh",
        match &scene.mesh {
            MeshSource::File(path) => object(vec![field("file", text(path))]),
            MeshSource::Inline(_) => inline_mesh::write(mesh, "  "),
        },
    ));
    if let Some(pose) = &scene.pose {
        let own = match pose {
            Pose::File(path) => field("file", text(path)),
            Pose::Positions(positions) => field("positions", rows(positions.iter().map(point), "")),
        };
        fields.push(field("pose", object(vec![own])));
    }
    if let Some(current) = &scene.current {
        fields.push(field("current", rows(current.iter().map(point), "")));
    }
    if !scene.sets.is_empty() {
        let sets =
            scene.sets.iter().map(|(name, set)| format!("{}: {}", text(name), write_set(set)));
        fields.push(field("sets", lines('{', sets.collect(), '}')));
    }
    // Written even when empty, since constraints are the main content of a scene.
    fields.push(field(
        "constraints",
        lines('[', scene.constraints.iter().map(constraint::write).collect(), ']'),
    ));
    if !scene.handles.is_empty() {
        fields.push(field(
            "handles",
            lines('[', scene.handles.iter().map(handle::write).collect(), ']'),
        ));
    }
    let defaults = Scene::new(scene.mesh.clone());
    let mut add = |name, fields_of: Vec<String>| {
        if !fields_of.is_empty() {
            fields.push(field(name, object(fields_of)));
        }
    };
    let (w, dw) = (scene.weights, defaults.weights);
    add(
        "weights",
        [
            ("shape", w.shape, dw.shape),
            ("close", w.close, dw.close),
            ("smooth", w.smooth, dw.smooth),
        ]
        .into_iter()
        .filter(|(_, value, default)| value != default)
        .map(|(key, value, _)| field(key, number(value)))
        .collect(),
    );
    add("closeness", closeness::write(&scene.closeness));
    let mut smoothness = Vec::new();
    if scene.smoothness.of != defaults.smoothness.of {
        smoothness.push(field("of", text(scene.smoothness.of.word())));
    }
    if scene.smoothness.weighting != defaults.smoothness.weighting {
        smoothness.push(field("weighting", text(scene.smoothness.weighting.word())));
    }
    add("smoothness", smoothness);
    add("solver", solver(scene, &defaults));
    if let Some(lesson) = &scene.lesson {
        fields.push(field("lesson", lesson::write(lesson)));
    }
    if let Some(build) = &scene.build {
        fields.push(field("build", object(write_build(build))));
    }
    if !scene.variants.kept.is_empty() {
        fields.push(field("variants", object(write_variants(&scene.variants))));
    }
    if !scene.steps.is_empty() {
        let steps = scene.steps.iter().map(write_step).collect();
        fields.push(field("steps", lines('[', steps, ']')));
    }
    format!("{{\n  {}\n}}\n", fields.join(",\n  "))
}

fn write_step(step: &Slide) -> String {
    serde_json::to_string(step).expect("a step is an object")
}

fn write_variants(variants: &Variants) -> Vec<String> {
    let kept = variants.kept.iter().map(|variant| {
        let positions = rows(variant.positions.iter().map(point), "");
        object(vec![field("name", text(&variant.name)), field("positions", positions)])
    });
    let mut fields = vec![field("kept", lines('[', kept.collect(), ']'))];
    fields.extend(variants.design.map(|index| field("design", index.to_string())));
    fields
}

/// Returns the build settings that are not at their defaults.
fn write_build(build: &BuildSettings) -> Vec<String> {
    let values = |settings: &BuildSettings| match serde_json::to_value(settings) {
        Ok(Value::Object(values)) => values,
        _ => Map::new(),
    };
    let defaults = values(&BuildSettings::default());
    let own = values(build).into_iter().filter(|(key, value)| defaults.get(key) != Some(value));
    own.map(|(key, value)| field(&key, value.to_string())).collect()
}

fn solver(scene: &Scene, defaults: &Scene) -> Vec<String> {
    let (s, d) = (scene.solver, defaults.solver);
    let mut fields = Vec::new();
    if s.iterations != d.iterations {
        fields.push(field("iterations", s.iterations.to_string()));
    }
    if s.tolerance != d.tolerance {
        fields.push(field("tolerance", number(s.tolerance)));
    }
    if s.accelerator != d.accelerator {
        fields.push(field("accelerator", text(s.accelerator.word())));
    }
    if s.window != d.window {
        fields.push(field("window", s.window.to_string()));
    }
    if s.mean_centring != d.mean_centring {
        fields.push(field("mean_centring", s.mean_centring.to_string()));
    }
    if s.monotone != d.monotone {
        fields.push(field("monotone", s.monotone.to_string()));
    }
    if s.factorization != d.factorization {
        fields.push(field("factorization", text(s.factorization.word())));
    }
    if s.shortest_edge != d.shortest_edge {
        let ratio = s.shortest_edge.map_or_else(|| "null".to_owned(), number);
        fields.push(field("shortest_edge", ratio));
    }
    fields
}

fn write_set(set: &Set) -> String {
    let mut fields = Vec::new();
    if !set.vertices.is_empty() {
        fields.push(field("vertices", indices::write(&set.vertices)));
    }
    if !set.faces.is_empty() {
        fields.push(field("faces", indices::write(&set.faces)));
    }
    object(fields)
}
