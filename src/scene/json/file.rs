//! Files: checks of format and version before their content is read, and writing.

use super::layout::laid_out;
use crate::constraint::Set;
use crate::json::{JsonError, SplitKeys, from_text, object, present};
use crate::mesh::Mesh;
use crate::scene::validate::check_handle_numbers;
use crate::scene::{MeshSource, Results, Scene, SceneError};
use serde::de::value::MapAccessDeserializer;
use serde::de::{DeserializeOwned, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};
use std::fmt;
use std::marker::PhantomData;

/// The value of `format` in scene files.
pub const FORMAT: &str = "shape-up-scene";
/// Version of the files that are read and written.
pub const VERSION: u32 = 1;

/// The value of `format` in files of results.
const RESULTS: &str = "shape-up-results";

impl Scene {
    /// Reads a scene file.
    ///
    /// # Errors
    /// If the text is not JSON (with line and column), or not a scene of version 1 (with the JSON
    /// path, the value found and the value expected).
    pub fn from_json(text: &str) -> Result<Scene, SceneError> {
        let scene: Scene = read_file(text, "a scene", FORMAT)?;
        let is_empty = |set: &Set| set.vertices.is_empty() && set.faces.is_empty();
        if let Some((name, _)) = scene.sets.iter().find(|(_, set)| is_empty(set)) {
            let error = JsonError::new("", "the set is empty, expected \"vertices\" or \"faces\"");
            return Err(error.below_key(name).below_key("sets").into());
        }
        scene.check_numbers()?;
        Ok(scene)
    }

    /// Returns the scene as the text of a file; `mesh` is written inline if [`Scene::mesh`] is
    /// inline. Default values are left out. The same scene always gives the same text, and numbers
    /// read back to the same bits.
    pub fn to_json(&self, mesh: &Mesh) -> String {
        let mesh = match &self.mesh {
            MeshSource::File(path) => MeshSource::File(path.clone()),
            MeshSource::Inline(_) => MeshSource::Inline(Box::new(mesh.clone())),
        };
        write_file(FORMAT, &Scene { mesh, ..self.clone() })
    }
}

impl Results {
    /// Reads a file of results.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str) -> Result<Results, SceneError> {
        let results: Results = read_file(text, "results", RESULTS)?;
        (0..).zip(&results.handles).try_for_each(|(i, handle)| check_handle_numbers(i, handle))?;
        Ok(results)
    }

    /// Writes the file that [`Results::from_json`] reads.
    pub fn to_json(&self) -> String {
        write_file(RESULTS, self)
    }
}

#[derive(Serialize)]
struct Written<'a, T> {
    format: &'static str,
    version: u32,
    #[serde(flatten)]
    content: &'a T,
}

fn write_file<T: Serialize>(format: &'static str, content: &T) -> String {
    laid_out(&Written { format, version: VERSION, content })
}

/// Reads a file of this `format`; `what` describes it in errors.
fn read_file<T: DeserializeOwned>(text: &str, what: &str, format: &str) -> Result<T, JsonError> {
    if text.trim().is_empty() {
        return Err(JsonError::new("", format!("the file is empty, expected {what}")));
    }
    check_header(text, what, format)?;
    from_text(text).map(|Content(content)| content)
}

/// The keys that [`check_header`] reads.
const HEADER: [&str; 2] = ["format", "version"];

#[derive(Deserialize)]
struct Header {
    #[serde(default, deserialize_with = "present")]
    format: Option<Value>,
    #[serde(default, deserialize_with = "present")]
    version: Option<Value>,
}

/// Checks format and version wherever they are in the file: the keys of a later version may be
/// unknown.
fn check_header(text: &str, what: &str, format: &str) -> Result<(), JsonError> {
    #[derive(Deserialize)]
    struct File(#[serde(deserialize_with = "object")] Header);

    let File(header) =
        from_text(text).map_err(|error| match error.message.strip_suffix("an object") {
            Some(found) if error.path.is_empty() => {
                JsonError::new("", format!("{found}{what}: an object"))
            }
            _ => error,
        })?;
    let given = |value: Option<Value>, key: &str, expected: &str| {
        let missing = || JsonError::new("", format!("`{key}` is missing, expected {expected}"));
        value.ok_or_else(missing)
    };
    let expected = format!("\"{format}\"");
    let own = given(header.format, "format", &format!("\"format\": {expected}"))?;
    if own != format {
        return Err(JsonError::found(&own, &expected).below_key("format"));
    }
    let own = given(header.version, "version", &VERSION.to_string())?;
    if own == VERSION {
        return Ok(());
    }
    let error = match own.as_u64().filter(|&later| later > VERSION.into()) {
        Some(later) => JsonError::new(
            "",
            format!(
                "this is version {later} of {format}, this program reads version {VERSION}: open it with a newer version of Shape-Up"
            ),
        ),
        None => JsonError::found(&own, &VERSION.to_string()),
    };
    Err(error.below_key("version"))
}

/// What a file holds beside its header.
struct Content<T>(T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Content<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Content<T>, D::Error> {
        from.deserialize_map(ContentVisitor(PhantomData))
    }
}

struct ContentVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for ContentVisitor<T> {
    type Value = Content<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Content<T>, A::Error> {
        let apart = &mut Map::new();
        let rest = SplitKeys { map, is_apart: |key: &str| HEADER.contains(&key), apart };
        T::deserialize(MapAccessDeserializer::new(rest)).map(Content)
    }
}
