//! JSON forms of edits and selection requests, as sent by hosts.

use super::constraint_target::ConstraintTarget;
use super::edit_list::{Edit, NewConstraint};
use super::remeshing::Remeshing;
use crate::json::{Entries, JsonError, from_text, from_value};
use crate::scene::{ConstraintSpec, Scene, SceneError, kind_of};
use crate::session::selection::SelectRequest;
use crate::solve::Require;
use serde::de::{Deserialize, Deserializer, Error};
use serde_json::{Map, Value};

/// The key of an edit that names it.
const TYPE: &str = "type";

impl Edit {
    /// Reads an edit of `document`: an object with its `type`, which is the name of the variant in
    /// camel case, and its fields. A constraint is written as in a scene file, but with its
    /// parameters in `params` and `on` as a [`ConstraintTarget`]. Weights that are not given stay
    /// as they are.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str, document: &Scene) -> Result<Edit, SceneError> {
        let Entries(entries) = from_text(text)?;
        let mut fields: Map<String, Value> = entries.into_iter().collect();
        let name = match fields.shift_remove(TYPE) {
            Some(Value::String(name)) => name,
            Some(other) => return Err(JsonError::found(&other, "a string").below_key(TYPE).into()),
            None => return Err(JsonError::missing_key(TYPE).into()),
        };
        if name == "setWeights" {
            fields.retain(|_, weight| !weight.is_null());
            let own = document.weights;
            for (key, own) in [("shape", own.shape), ("close", own.close), ("smooth", own.smooth)] {
                fields.entry(key).or_insert(own.into());
            }
        }
        let edit = Value::Object(Map::from_iter([(name.clone(), Value::Object(fields))]));
        Ok(from_value(edit).map_err(|error| {
            if error.path.is_empty() && error.message.starts_with("unknown variant") {
                return JsonError::new(TYPE, format!("unknown edit `{name}`"));
            }
            // Error paths within a lesson are relative to the lesson.
            match error.path.strip_prefix("lesson") {
                Some(path) => JsonError::new(path.trim_start_matches('.'), error.message),
                None => error,
            }
        })?)
    }
}

impl Remeshing {
    /// Reads an operation and what it is applied to, an object with the fields by name.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str) -> Result<Remeshing, SceneError> {
        Ok(from_text(text)?)
    }
}

impl SelectRequest {
    /// Reads a request, an object with the fields by name; `from` is empty by default.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str) -> Result<SelectRequest, SceneError> {
        Ok(from_text(text)?)
    }
}

/// A row to be added, in JSON.
#[derive(serde::Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
struct ConstraintEntry {
    kind: String,
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Selector"))]
    on: ConstraintTarget,
    weight: f64,
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, ParamValue>"))]
    params: Map<String, Value>,
}

impl<'de> Deserialize<'de> for NewConstraint {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<NewConstraint, D::Error> {
        let ConstraintEntry { kind: id, on: ConstraintTarget { on, set }, weight, params } =
            ConstraintEntry::deserialize(from)?;
        let kind = kind_of(&id, params).map_err(D::Error::custom)?;
        let (name, require, eased) = (String::new(), Require::Soft, None);
        let spec = ConstraintSpec { kind, on, weight, enabled: true, name, require, eased };
        Ok(NewConstraint { spec, set })
    }
}
