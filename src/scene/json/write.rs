//! The scene as JSON: one line per constraint, handle and set; only what is not the default.

use super::constraint::default_params;
use super::{FORMAT, VERSION, closeness, indices, inline_mesh, lesson, selector};
use crate::constraint::Set;
use crate::mesh::{Decimal, Mesh, Point};
use crate::scene::{
    ConstraintSpec, HANDLE_WEIGHT, HandleSpec, Hold, MeshSource, Scene, Up, Worded,
};

pub(super) fn scene(scene: &Scene, mesh: &Mesh) -> String {
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
    if let Some(current) = &scene.current {
        fields.push(field("current", rows(current.iter().map(point), "")));
    }
    if !scene.sets.is_empty() {
        let sets =
            scene.sets.iter().map(|(name, set)| format!("{}: {}", text(name), write_set(set)));
        fields.push(field("sets", lines('{', sets.collect(), '}')));
    }
    // Also when empty: the list is what a scene is about.
    fields.push(field(
        "constraints",
        lines('[', scene.constraints.iter().map(constraint).collect(), ']'),
    ));
    if !scene.handles.is_empty() {
        fields.push(field("handles", lines('[', scene.handles.iter().map(handle).collect(), ']')));
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
    format!("{{\n  {}\n}}\n", fields.join(",\n  "))
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
    fields
}

pub(super) fn constraint(spec: &ConstraintSpec) -> String {
    let id = spec.kind.info().id;
    let mut fields = vec![field("kind", text(id)), field("on", selector::write(&spec.on))];
    if spec.weight != 1.0 {
        fields.push(field("weight", number(spec.weight)));
    }
    if !spec.enabled {
        fields.push(field("enabled", "false".to_owned()));
    }
    if !spec.name.is_empty() {
        fields.push(field("name", text(&spec.name)));
    }
    let defaults = default_params(id);
    if let serde_json::Value::Object(params) = spec.kind.params() {
        for (key, value) in params {
            if defaults.get(&key) != Some(&value) {
                fields.push(field(&key, value.to_string()));
            }
        }
    }
    object(fields)
}

pub(super) fn handle(handle: &HandleSpec) -> String {
    let mut fields = vec![field("vertices", indices::write(&handle.vertices))];
    if let Some(targets) = &handle.targets {
        fields.push(field("targets", points(targets)));
    }
    match handle.hold {
        Hold::Fixed => fields.push(field("fixed", "true".to_owned())),
        Hold::Soft { weight } if weight != HANDLE_WEIGHT => {
            fields.push(field("weight", number(weight)));
        }
        Hold::Soft { .. } => {}
    }
    object(fields)
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

pub(super) fn field(key: &str, value: String) -> String {
    format!("{}: {value}", text(key))
}

pub(super) fn object(fields: Vec<String>) -> String {
    format!("{{ {} }}", fields.join(", "))
}

/// One item per line.
pub(super) fn lines(open: char, items: Vec<String>, close: char) -> String {
    if items.is_empty() {
        return format!("{open}{close}");
    }
    format!("{open}\n    {}\n  {close}", items.join(",\n    "))
}

/// Rows in as few lines as are good to read: what a scene holds is long, not deep.
pub(super) fn rows(rows: impl Iterator<Item = String>, indent: &str) -> String {
    let mut text = String::from("[");
    let mut width = 0;
    for (i, row) in rows.enumerate() {
        if i > 0 {
            text.push(',');
        }
        if i == 0 || width + row.len() > 96 {
            text.push_str(&format!("\n{indent}    "));
            width = 0;
        } else {
            text.push(' ');
        }
        width += row.len() + 2;
        text.push_str(&row);
    }
    text.push_str(&format!("\n{indent}  ]"));
    text
}

fn points(points: &[Point]) -> String {
    let items: Vec<_> = points.iter().map(point).collect();
    format!("[{}]", items.join(", "))
}

pub(super) fn point(point: &Point) -> String {
    let [x, y, z] = point.map(number);
    format!("[{x}, {y}, {z}]")
}

/// The shortest decimal that reads back to the same bits.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() { Decimal(value).to_string() } else { "null".to_owned() }
}

/// A JSON string.
pub(super) fn text(value: &str) -> String {
    serde_json::Value::from(value).to_string()
}
