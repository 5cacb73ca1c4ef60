//! Selections, and requests for them.

use crate::json::{indices, word};
use crate::scene::{NamedEnum, SceneError};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The kind of element to select.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum Mode {
    /// Vertices.
    Vertices,
    /// Edges, indexed as in [`crate::mesh::Topology::edges`].
    Edges,
    /// Faces.
    Faces,
}

impl NamedEnum for Mode {
    const WORDS: &'static [(&'static str, Mode)] =
        &[("vertices", Mode::Vertices), ("edges", Mode::Edges), ("faces", Mode::Faces)];
}

/// Some vertices, edges and faces.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Selection {
    /// Indices of vertices.
    #[serde(deserialize_with = "indices::deserialize")]
    pub vertices: Vec<u32>,
    /// Indices of edges, as in [`crate::mesh::Topology::edges`].
    #[serde(deserialize_with = "indices::deserialize")]
    pub edges: Vec<u32>,
    /// Indices of faces.
    #[serde(deserialize_with = "indices::deserialize")]
    pub faces: Vec<u32>,
}

/// A selection operation, applied to a selection.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SelectRequest {
    /// The id of an [`Operation`](super::Operation).
    pub operation: String,
    /// The kind of element; the result is of this kind unless the operation gives another.
    #[serde(deserialize_with = "word")]
    pub mode: Mode,
    /// The current selection.
    #[serde(default)]
    pub from: Selection,
    /// The parameters that differ from their defaults.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, ParamValue>"))]
    pub params: Map<String, Value>,
}

pub(super) fn error(path: &str, message: String) -> SceneError {
    SceneError { path: path.to_owned(), message }
}
