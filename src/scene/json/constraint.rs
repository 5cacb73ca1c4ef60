//! The entries of the lists of constraints and of handles.

use crate::constraint::{KINDS, Kind, KindError, Selector};
use crate::json::{
    Either, JsonError, Object, SplitKeys, indices, object, points, present, word_or,
};
use crate::mesh::Point;
use crate::scene::{ConstraintSpec, EasedFaces, HANDLE_WEIGHT, HandleSpec, Hold, RowNumber};
use crate::solve::Require;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Unexpected, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Map, Value};
use std::fmt;

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
    eased: Option<Object<EasedFaces>>,
}

fn one() -> f64 {
    1.0
}

fn yes() -> bool {
    true
}

impl<'de> Deserialize<'de> for ConstraintSpec {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<ConstraintSpec, D::Error> {
        from.deserialize_map(SpecVisitor)
    }
}

struct SpecVisitor;

impl<'de> Visitor<'de> for SpecVisitor {
    type Value = ConstraintSpec;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a constraint: an object with \"kind\" and \"on\"")
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ConstraintSpec, A::Error> {
        let mut params = Map::new();
        let is_apart = |key: &str| !KEYS.contains(&key);
        let common = MapAccessDeserializer::new(SplitKeys { map, is_apart, apart: &mut params });
        let Common { kind: id, on, weight, enabled, name, require, eased } =
            Common::deserialize(common)?;
        let kind = kind_of(&id, params).map_err(A::Error::custom)?;
        let eased = eased.map(|Object(eased)| eased);
        let number = RowNumber::default();
        Ok(ConstraintSpec { kind, on, weight, enabled, name, require, eased, number })
    }
}

/// Returns the kind named `id` with these parameters; paths of errors are within the entry.
pub(crate) fn kind_of(id: &str, params: Map<String, Value>) -> Result<Kind, JsonError> {
    let given: Vec<_> = params.keys().cloned().collect();
    Kind::new(id, Value::Object(params)).map_err(|error| match error {
        KindError::Unknown => {
            let ids: Vec<_> = KINDS.iter().map(|info| info.id).collect();
            let message = format!("unknown kind {id:?}, expected one of {}", ids.join(", "));
            JsonError::new("kind", message)
        }
        KindError::Params { path, message } => {
            let known = parameter_keys(id);
            match given.iter().find(|key| !known.contains(key)) {
                Some(key) => {
                    let own = known.iter().map(|key| &**key);
                    JsonError::unknown_key(key, &KEYS.into_iter().chain(own).collect::<Vec<_>>())
                }
                None => JsonError { path, message },
            }
        }
    })
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
    match Kind::new(id, Value::Object(Map::new())).map(|kind| kind.params()) {
        Ok(Value::Object(params)) => params,
        _ => Map::new(),
    }
}

impl Serialize for ConstraintSpec {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let id = self.kind.info().id;
        let mut map = to.serialize_map(None)?;
        map.serialize_entry("kind", id)?;
        map.serialize_entry("on", &self.on)?;
        if self.weight != 1.0 {
            map.serialize_entry("weight", &self.weight)?;
        }
        if !self.enabled {
            map.serialize_entry("enabled", &false)?;
        }
        if !self.name.is_empty() {
            map.serialize_entry("name", &self.name)?;
        }
        if self.require != Require::Soft {
            map.serialize_entry("require", &self.require)?;
        }
        if let Some(eased) = &self.eased {
            map.serialize_entry("eased", eased)?;
        }
        let defaults = default_params(id);
        let params = self.kind.params();
        let params = params.as_object().into_iter().flatten();
        for (key, value) in params.filter(|(key, value)| defaults.get(*key) != Some(value)) {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}

/// The `require` of a constraint with a tolerance.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Within {
    within: f64,
}

impl<'de> Deserialize<'de> for Require {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Require, D::Error> {
        const FORMS: &str = "\"soft\", \"exact\" or { \"within\": LENGTH }";
        match word_or(from, FORMS)? {
            Either::Object(Within { within }) => Ok(Require::Within(within)),
            Either::Word(word) => match &*word {
                "soft" => Ok(Require::Soft),
                "exact" => Ok(Require::Exact),
                _ => Err(D::Error::invalid_value(Unexpected::Str(&word), &FORMS)),
            },
        }
    }
}

impl Serialize for Require {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Require::Soft => to.serialize_str("soft"),
            Require::Exact => to.serialize_str("exact"),
            Require::Within(length) => to.collect_map([("within", length)]),
        }
    }
}

#[derive(serde::Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
struct HandleFile {
    #[serde(with = "indices")]
    vertices: Vec<u32>,
    #[serde(default, deserialize_with = "points", skip_serializing_if = "Option::is_none")]
    targets: Option<Vec<Point>>,
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    weight: Option<f64>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    fixed: bool,
}

impl<'de> Deserialize<'de> for HandleSpec {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<HandleSpec, D::Error> {
        handle_of(object(from)?).map_err(D::Error::custom)
    }
}

fn handle_of(file: HandleFile) -> Result<HandleSpec, JsonError> {
    let HandleFile { vertices, targets, weight, fixed } = file;
    let error = |path, message: &str| Err(JsonError::new(path, message));
    if vertices.is_empty() {
        return error("vertices", "the list is empty, expected at least one vertex");
    }
    let hold = match weight {
        Some(_) if fixed => {
            return error("weight", "a fixed handle is met exactly and takes no weight");
        }
        _ if fixed => Hold::Fixed,
        weight => Hold::Soft { weight: weight.unwrap_or(HANDLE_WEIGHT) },
    };
    Ok(HandleSpec { vertices, targets, hold })
}

impl Serialize for HandleSpec {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let weight = match self.hold {
            Hold::Soft { weight } if weight != HANDLE_WEIGHT => Some(weight),
            Hold::Soft { .. } | Hold::Fixed => None,
        };
        let (vertices, targets) = (self.vertices.clone(), self.targets.clone());
        HandleFile { vertices, targets, weight, fixed: self.hold == Hold::Fixed }.serialize(to)
    }
}
