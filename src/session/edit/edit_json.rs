//! JSON forms of edits, selection requests and constraint targets, as sent by hosts.

use super::constraint_target::ConstraintTarget;
use super::edit_list::{Edit, NewConstraint};
use super::remeshing::Remeshing;
use crate::constraint::Set;
use crate::json::{JsonError, Tree, indices, parse, read, read_tree};
use crate::scene::{Scene, SceneError};
use crate::session::selection::SelectRequest;
use serde::de::{Deserialize, Deserializer, Error};
use serde_json::{Map, Value};

impl Edit {
    /// Reads an edit of `document`: an object with its `type`, which is the name of the variant in
    /// camel case, and its fields. A constraint is written as in a scene file, but with its
    /// parameters in `params` and `on` as a [`ConstraintTarget`]. Weights that are not given stay
    /// as they are.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str, document: &Scene) -> Result<Edit, SceneError> {
        let mut edit = tree(text)?;
        let named = |edit: &Tree| match edit.get("type") {
            Some(Tree::Text(name)) => name.clone(),
            _ => String::new(),
        };
        if let ("setWeights", Tree::Object(entries)) = (&*named(&edit), &mut edit) {
            let own = serde_json::to_value(document.weights).expect("they are numbers");
            let missing = own.as_object().into_iter().flatten();
            entries.retain(|(_, weight)| *weight != Tree::Null);
            for (key, weight) in missing {
                if !entries.iter().any(|(given, _)| given == key) {
                    entries.push((key.clone(), weight.into()));
                }
            }
        }
        let read = read_tree(&edit).map_err(|error| match &*error.path {
            "type" => JsonError::new("type", format!("unknown edit `{}`", named(&edit))),
            // Error paths within a lesson are relative to the lesson.
            path => match path.strip_prefix("lesson") {
                Some(path) => JsonError::new(path.trim_start_matches('.'), error.message),
                None => error,
            },
        });
        Ok(read?)
    }
}

impl Remeshing {
    /// Reads an operation and what it is applied to, an object with the fields by name.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str) -> Result<Remeshing, SceneError> {
        Ok(read_tree(&tree(text)?)?)
    }
}

impl SelectRequest {
    /// Reads a request, an object with the fields by name; `from` is empty by default.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str) -> Result<SelectRequest, SceneError> {
        Ok(read_tree(&tree(text)?)?)
    }
}

impl ConstraintTarget {
    /// Reads an array of targets: each is a selector as in a scene file, in which `in` may also be
    /// a set without a name, `{"faces": ...}` or `{"vertices": ...}`.
    ///
    /// # Errors
    /// As [`Scene::from_json`], with the path within the target.
    pub fn all_from_json(text: &str) -> Result<Vec<ConstraintTarget>, SceneError> {
        let places: Vec<Value> = read_tree(&tree(text)?)?;
        places.iter().map(|place| Ok(read(place)?)).collect()
    }
}

fn tree(text: &str) -> Result<Tree, JsonError> {
    indices::begin();
    parse(text)
}

impl<'de> Deserialize<'de> for ConstraintTarget {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<ConstraintTarget, D::Error> {
        let (on, set) = with_set_named(Value::deserialize(from)?).map_err(D::Error::custom)?;
        let on = read(&on).map_err(D::Error::custom)?;
        Ok(ConstraintTarget { on, set })
    }
}

/// Replaces a set without a name in a selector by [`ConstraintTarget::UNNAMED`], and returns both.
fn with_set_named(mut on: Value) -> Result<(Value, Option<Set>), JsonError> {
    let mut unnamed = None;
    if let Some(within) = on.get_mut("in").filter(|within| within.is_object()) {
        unnamed = Some(read(within)?);
        *within = ConstraintTarget::UNNAMED.into();
    }
    Ok((on, unnamed))
}

/// A row to be added, in JSON.
#[derive(serde::Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
struct ConstraintEntry {
    kind: String,
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Selector"))]
    on: Value,
    weight: f64,
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, ParamValue>"))]
    params: Map<String, Value>,
}

/// Reads the row as an entry of a scene file.
impl<'de> Deserialize<'de> for NewConstraint {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<NewConstraint, D::Error> {
        let ConstraintEntry { kind, on, weight, params: mut entry } =
            ConstraintEntry::deserialize(from)?;
        let (on, set) = with_set_named(on).map_err(D::Error::custom)?;
        entry.insert("kind".to_owned(), kind.into());
        entry.insert("on".to_owned(), on);
        entry.insert("weight".to_owned(), weight.into());
        let spec = read(&Value::Object(entry)).map_err(D::Error::custom)?;
        Ok(NewConstraint { spec, set })
    }
}
