//! Files: checks of format and version before their content is read.

use crate::constraint::Set;
use crate::json::{JsonError, Tree, found, indices, parse, read_tree};
use crate::scene::{Results, Scene, SceneError};
use serde::de::DeserializeOwned;

/// The value of `format` in scene files.
pub const FORMAT: &str = "shape-up-scene";
/// Version of the files that are read and written.
pub const VERSION: u32 = 1;

/// The value of `format` in files of results.
pub(super) const RESULTS: &str = "shape-up-results";

impl Scene {
    /// Reads a scene file.
    ///
    /// # Errors
    /// If the text is not JSON (with line and column), or not a scene of version 1 (with the JSON
    /// path, the value found and the value expected).
    pub fn from_json(text: &str) -> Result<Scene, SceneError> {
        let scene: Scene = read_file(text, "a scene: an object", FORMAT)?;
        let is_empty = |set: &Set| set.vertices.is_empty() && set.faces.is_empty();
        if let Some((name, _)) = scene.sets.iter().find(|(_, set)| is_empty(set)) {
            let error = JsonError::new("", "the set is empty, expected \"vertices\" or \"faces\"");
            return Err(error.below_key(name).below_key("sets").into());
        }
        scene.check_numbers()?;
        Ok(scene)
    }
}

impl Results {
    /// Reads a file of results.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str) -> Result<Results, SceneError> {
        Ok(read_file(text, "results: an object", RESULTS)?)
    }
}

/// Reads a value on its own, such as one constraint.
pub(super) fn from_json<T: DeserializeOwned>(text: &str) -> Result<T, SceneError> {
    indices::begin();
    Ok(read_tree(&parse(text)?)?)
}

/// Reads a file of this `format`; `what` describes it in errors. A later version is refused before
/// its keys are read, since some may be unknown.
fn read_file<T: DeserializeOwned>(text: &str, what: &str, format: &str) -> Result<T, JsonError> {
    if text.trim().is_empty() {
        return Err(JsonError::new("", "the file is empty, expected a scene"));
    }
    let mut document = parse(text)?;
    if !matches!(document, Tree::Object(_)) {
        return Err(found(document, what));
    }
    let mut take = |key: &str, expected: &str| {
        let missing = || JsonError::new("", format!("`{key}` is missing, expected {expected}"));
        document.remove(key).ok_or_else(missing)
    };
    let expected = format!("\"{format}\"");
    let own = take("format", &format!("\"format\": {expected}"))?;
    if own != Tree::Text(format.to_owned()) {
        return Err(found(own, &expected).below_key("format"));
    }
    let own = take("version", &VERSION.to_string())?;
    if own != Tree::Number(VERSION.into()) {
        let later = if let Tree::Number(own) = &own { own.as_u64() } else { None };
        let error = match later.filter(|&later| later > VERSION.into()) {
            Some(later) => JsonError::new(
                "",
                format!(
                    "this is version {later} of {format}, this program reads version {VERSION}: open it with a newer version of Shape-Up"
                ),
            ),
            None => found(own, &VERSION.to_string()),
        };
        return Err(error.below_key("version"));
    }
    indices::begin();
    read_tree(&document)
}
