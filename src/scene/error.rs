//! Errors of scene files.

use crate::constraint::{Element, KINDS};
use crate::json::JsonError;
use std::fmt;

/// An error in a scene, with its JSON path.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    /// JSON path, such as `constraints[2].on.set`; empty for the whole file.
    pub path: String,
    /// The fault, and what was expected instead.
    pub message: String,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            f.write_str(&self.message)
        } else {
            write!(f, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for SceneError {}

impl From<JsonError> for SceneError {
    fn from(error: JsonError) -> SceneError {
        let missing = error.missing().and_then(|key| expected_of(&error.path, key));
        let JsonError { path, mut message } = error;
        let (parent, key) = path.rsplit_once('.').unwrap_or(("", &path));
        if let Some(expected) = missing {
            message = format!("{message}, expected {expected}");
        } else if let Some(found) = message.strip_suffix("a number")
            && let Some(expected) = expected_of(parent, key)
        {
            message = found.to_owned() + &expected;
        }
        SceneError { path, message }
    }
}

/// Describes the expected value of a key of the object at the path `parent`, which is required or is a
/// number in a range.
fn expected_of(parent: &str, key: &str) -> Option<String> {
    let what = match key {
        "format" | "title" | "student" | "scene" | "time" | "name" | "id" => "a string",
        "mesh" => "{\"file\": ...} or a mesh",
        "positions" => "an array of points, or \"file\" with the path of a mesh",
        "kind" => {
            let ids: Vec<_> = KINDS.iter().map(|info| info.id).collect();
            return Some(format!("one of {}", ids.join(", ")));
        }
        "on" | "each" => return Some(forms_of_selectors()),
        "vertices" => "a list of indices",
        "weight" if parent.starts_with("handles[") => "a number above 0",
        // That of handles is above 0, and the path of an edit does not tell which one it is.
        "weight" | "at_most" if !parent.is_empty() => "a number from 0",
        "corners" => "an angle in degrees from 0 to 180",
        "text" => "the text of the task",
        "goals" => "an array of goals",
        "index" => "the index of a row",
        _ => return None,
    };
    Some(what.to_owned())
}

pub(super) fn forms_of_selectors() -> String {
    let all = Element::ALL.into_iter().filter_map(Element::word_for_all);
    let all: Vec<_> = all.map(|word| format!("\"{word}\"")).collect();
    format!("{}, {{\"each\": ...}}, {{\"set\": NAME}} or {{\"vertices\": LIST}}", all.join(", "))
}
