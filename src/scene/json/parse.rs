//! From text to a tree, and whether the tree is what it says it is.

use super::node::{JsonCursor, Node};
use crate::scene::SceneError;

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

/// Checks that a document is of this `format`, and of the `version` that is read here; `what` says what it
/// would be.
pub(super) fn check_format(
    at: &JsonCursor<'_>,
    what: &str,
    format: &str,
    version: u32,
) -> Result<(), SceneError> {
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
