//! "closeness": the target of the closeness energy. Another surface is written like the mesh of the
//! scene.

use super::text::{field, number, object, text};
use super::{mesh as inline_mesh, selector};
use crate::json::{found, present, read};
use crate::scene::{
    BoundaryCloseness, BoundaryRequire, Closeness, ClosenessTo, ClosenessWeight, MeshSource,
    NamedEnum, Target,
};
use serde::de::{Deserialize, Deserializer, Error};
use serde_json::Value;
use std::rc::Rc;

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct ClosenessFile {
    #[serde(default)]
    to: To,
    #[serde(default)]
    weights: Vec<ClosenessWeight>,
    #[serde(default, deserialize_with = "present")]
    boundary: Option<BoundaryCloseness>,
}

#[derive(Default)]
struct To(ClosenessTo, Option<Target>);

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct TargetFile {
    #[serde(deserialize_with = "mesh_or_path")]
    mesh: MeshSource,
}

/// Reads a mesh as in "mesh" of the scene, or only the path of its file.
fn mesh_or_path<'de, D: Deserializer<'de>>(from: D) -> Result<MeshSource, D::Error> {
    match Value::deserialize(from)? {
        Value::String(path) => Ok(MeshSource::File(path)),
        mesh @ Value::Object(_) => read(&mesh).map_err(D::Error::custom),
        other => Err(D::Error::custom(found(&other, "the path of a mesh file, or a mesh"))),
    }
}

impl<'de> Deserialize<'de> for Closeness {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Closeness, D::Error> {
        let ClosenessFile { to: To(to, target), weights, boundary } =
            ClosenessFile::deserialize(from)?;
        Ok(Closeness { to, target, weights, boundary })
    }
}

impl<'de> Deserialize<'de> for To {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<To, D::Error> {
        match Value::deserialize(from)? {
            Value::Object(entries) => read(&Value::Object(entries)).map(|TargetFile { mesh }| {
                let target = match mesh {
                    MeshSource::File(path) => Target::File(path),
                    MeshSource::Inline(mesh) => Target::Mesh(Rc::from(mesh)),
                };
                To(ClosenessTo::Target, Some(target))
            }),
            other => {
                let word = other.as_str().and_then(ClosenessTo::of_word);
                let word = word.filter(|word| *word != ClosenessTo::Target);
                let expected = "\"surface\" or \"rest\" or \"none\" or { \"mesh\": ... }";
                word.map(|to| To(to, None)).ok_or_else(|| found(&other, expected))
            }
        }
        .map_err(D::Error::custom)
    }
}

pub(super) fn write(closeness: &Closeness) -> Vec<String> {
    let mut fields = Vec::new();
    match &closeness.target {
        Some(target) if closeness.to == ClosenessTo::Target => {
            let mesh = match target {
                Target::File(path) => object(vec![field("file", text(path))]),
                Target::Mesh(mesh) => inline_mesh::write(mesh, "    "),
            };
            fields.push(field("to", object(vec![field("mesh", mesh)])));
        }
        _ if closeness.to != ClosenessTo::default() => {
            fields.push(field("to", text(closeness.to.word())));
        }
        _ => {}
    }
    if !closeness.weights.is_empty() {
        let entry = |entry: &ClosenessWeight| {
            object(vec![
                field("on", selector::write(&entry.on)),
                field("weight", number(entry.weight)),
            ])
        };
        let entries: Vec<_> = closeness.weights.iter().map(entry).collect();
        fields.push(field("weights", format!("[{}]", entries.join(", "))));
    }
    if let Some(boundary) = closeness.boundary {
        // Written even at the default, since it defines the corners.
        let mut entries = vec![field("corners", number(boundary.corners))];
        if boundary.require != BoundaryRequire::default() {
            entries.push(field("require", text(boundary.require.word())));
        }
        if boundary.weight != 1.0 {
            entries.push(field("weight", number(boundary.weight)));
        }
        fields.push(field("boundary", object(entries)));
    }
    fields
}
