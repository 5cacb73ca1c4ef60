//! One entry of the list of constraints: kind, selector, weight, and parameters of the kind.

use super::file::from_json;
use super::selector;
use super::text::{field, number, object, text};
use crate::constraint::{KINDS, Kind, KindError, Selector};
use crate::json::{JsonError, found, indices, read};
use crate::scene::{ConstraintSpec, EasedFaces, SceneError};
use crate::solve::Require;
use serde::de::{Deserialize, Deserializer, Error};
use serde_json::{Map, Value};

impl ConstraintSpec {
    /// Reads one entry of a scene's list of constraints.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(json: &str) -> Result<ConstraintSpec, SceneError> {
        from_json(json)
    }
}

impl<'de> Deserialize<'de> for ConstraintSpec {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<ConstraintSpec, D::Error> {
        match Value::deserialize(from)? {
            Value::Object(entries) => spec_of(entries),
            other => Err(found(&other, "a constraint: an object with \"kind\" and \"on\"")),
        }
        .map_err(D::Error::custom)
    }
}

/// The keys common to all constraints; all others are parameters of the kind.
const KEYS: [&str; 7] = ["kind", "on", "weight", "enabled", "name", "require", "eased"];

#[derive(serde::Deserialize)]
struct Common {
    kind: String,
    on: Selector,
    #[serde(default = "one")]
    weight: f64,
    #[serde(default = "yes")]
    enabled: bool,
    #[serde(default)]
    name: String,
    #[serde(default)]
    require: Require,
    eased: Option<EasedFaces>,
}

fn one() -> f64 {
    1.0
}

fn yes() -> bool {
    true
}

fn spec_of(entries: Map<String, Value>) -> Result<ConstraintSpec, JsonError> {
    let (mut common, mut params) = (Map::new(), Map::new());
    for (key, value) in entries {
        let part = if KEYS.contains(&&*key) { &mut common } else { &mut params };
        part.insert(key, value);
    }
    let Common { kind: id, on, weight, enabled, name, require, eased } =
        read(&Value::Object(common))?;
    let given: Vec<_> = params.keys().cloned().collect();
    let kind = Kind::new(&id, Value::Object(params)).map_err(|error| match error {
        KindError::Unknown => {
            let ids: Vec<_> = KINDS.iter().map(|info| info.id).collect();
            let message = format!("unknown kind {id:?}, expected one of {}", ids.join(", "));
            JsonError::new("kind", message)
        }
        KindError::Params { path, message } => {
            let known = parameter_keys(&id);
            match given.iter().find(|key| !known.contains(key)) {
                Some(key) => {
                    let own = known.iter().map(|key| &**key);
                    JsonError::unknown_key(key, &KEYS.into_iter().chain(own).collect::<Vec<_>>())
                }
                None => JsonError { path, message },
            }
        }
    })?;
    Ok(ConstraintSpec { kind, on, weight, enabled, name, require, eased })
}

/// The `require` of a constraint with a tolerance.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Within {
    within: f64,
}

impl<'de> Deserialize<'de> for Require {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Require, D::Error> {
        match Value::deserialize(from)? {
            Value::String(word) if word == "soft" => Ok(Require::Soft),
            Value::String(word) if word == "exact" => Ok(Require::Exact),
            Value::Object(entries) => {
                read(&Value::Object(entries)).map(|Within { within }| Require::Within(within))
            }
            other => Err(found(&other, "\"soft\", \"exact\" or { \"within\": LENGTH }")),
        }
        .map_err(D::Error::custom)
    }
}

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

/// Returns the default parameters of a kind; empty if some have no default.
fn default_params(id: &str) -> Map<String, Value> {
    match Kind::new(id, serde_json::json!({})).map(|kind| kind.params()) {
        Ok(Value::Object(params)) => params,
        _ => Map::new(),
    }
}

/// Returns the constraint as one line of the list.
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
    match spec.require {
        Require::Soft => {}
        Require::Exact => fields.push(field("require", text("exact"))),
        Require::Within(length) => {
            fields.push(field("require", object(vec![field("within", number(length))])));
        }
    }
    if let Some(EasedFaces { within, faces }) = &spec.eased {
        let eased = vec![field("within", number(*within)), field("faces", indices::write(faces))];
        fields.push(field("eased", object(eased)));
    }
    let defaults = default_params(id);
    if let Value::Object(params) = spec.kind.params() {
        for (key, value) in params {
            if defaults.get(&key) != Some(&value) {
                fields.push(field(&key, value.to_string()));
            }
        }
    }
    object(fields)
}
