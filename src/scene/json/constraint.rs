//! One entry of the list of constraints: kind, selector, weight, and the parameters of the kind.

use super::node::JsonCursor;
use super::parse::parse;
use super::selector;
use super::text::{field, number, object, text};
use crate::constraint::{KINDS, Kind, KindError};
use crate::scene::{ConstraintSpec, SceneError};

impl ConstraintSpec {
    /// Reads one entry of a scene's list of constraints.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(json: &str) -> Result<ConstraintSpec, SceneError> {
        read(&JsonCursor::root(&parse(json)?))
    }
}

/// The keys that every constraint has; all others are parameters of its kind.
const KEYS: [&str; 5] = ["kind", "on", "weight", "enabled", "name"];

pub(crate) fn read(at: &JsonCursor<'_>) -> Result<ConstraintSpec, SceneError> {
    let entries = at.entries("a constraint: an object with \"kind\" and \"on\"")?;
    let ids: Vec<_> = KINDS.iter().map(|info| info.id).collect();
    let what = format!("one of {}", ids.join(", "));
    let kind = at.need("kind", &what)?;
    let id = kind.text(&what)?;
    let own = entries.iter().filter(|(key, _)| !KEYS.contains(key));
    let params = own.clone().map(|(key, value)| ((*key).to_owned(), value.node.to_value()));
    let kind = Kind::new(id, super::node::object(params)).map_err(|e| match e {
        KindError::Unknown => kind.error(format!("unknown kind {id:?}, expected {what}")),
        KindError::Params { path, message } => {
            let known = parameter_keys(id);
            match own.clone().find(|(key, _)| !known.iter().any(|k| k == key)) {
                Some((key, _)) => {
                    let known: Vec<_> =
                        KEYS.iter().copied().chain(known.iter().map(|k| &**k)).collect();
                    at.unknown_key(key, &known)
                }
                None => SceneError { path: join(&at.path(), &path), message },
            }
        }
    })?;
    let on = at.need("on", &selector::what())?;
    let on = selector::read(&on)?;
    let mut spec = ConstraintSpec { kind, on, weight: 1.0, enabled: true, name: String::new() };
    if let Some(weight) = at.get("weight") {
        spec.weight = weight.number("a number from 0")?;
    }
    if let Some(enabled) = at.get("enabled") {
        spec.enabled = enabled.truth()?;
    }
    if let Some(name) = at.get("name") {
        spec.name = name.text("a name")?.to_owned();
    }
    Ok(spec)
}

/// The keys of the parameters of a kind.
fn parameter_keys(id: &str) -> Vec<String> {
    let declared = KINDS.iter().filter(|info| info.id == id).flat_map(|info| info.params);
    let mut keys: Vec<_> = declared.map(|param| param.id.to_owned()).collect();
    for key in default_params(id).keys() {
        if !keys.contains(key) {
            keys.push(key.clone());
        }
    }
    keys
}

/// The parameters that a kind has when the scene gives none; empty when some have no default.
fn default_params(id: &str) -> serde_json::Map<String, serde_json::Value> {
    match Kind::new(id, serde_json::json!({})).map(|kind| kind.params()) {
        Ok(serde_json::Value::Object(params)) => params,
        _ => serde_json::Map::new(),
    }
}

/// One line of the list.
pub(super) fn write(spec: &ConstraintSpec) -> String {
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

/// A JSON path and one below it.
fn join(path: &str, below: &str) -> String {
    match below {
        "" => path.to_owned(),
        _ if path.is_empty() => below.to_owned(),
        _ if below.starts_with('[') => format!("{path}{below}"),
        _ => format!("{path}.{below}"),
    }
}
