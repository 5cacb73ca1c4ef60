//! One entry of the list of handles.

use super::text::{field, number, object, points};
use crate::json::{JsonError, indices, present};
use crate::mesh::Point;
use crate::scene::{HANDLE_WEIGHT, HandleSpec, Hold};
use serde::de::{Deserialize, Deserializer, Error};

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct HandleFile {
    #[serde(deserialize_with = "indices::deserialize")]
    vertices: Vec<u32>,
    #[serde(default, deserialize_with = "present")]
    targets: Option<Vec<Point>>,
    #[serde(default, deserialize_with = "present")]
    weight: Option<f64>,
    #[serde(default)]
    fixed: bool,
}

impl<'de> Deserialize<'de> for HandleSpec {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<HandleSpec, D::Error> {
        handle_of(HandleFile::deserialize(from)?).map_err(D::Error::custom)
    }
}

fn handle_of(file: HandleFile) -> Result<HandleSpec, JsonError> {
    let HandleFile { vertices, targets, weight, fixed } = file;
    let error = |path, message: &str| Err(JsonError::new(path, message));
    if vertices.is_empty() {
        return error("vertices", "the list is empty, expected at least one vertex");
    }
    if let Some(targets) = &targets
        && targets.len() != vertices.len()
    {
        let (found, expected) = (targets.len(), vertices.len());
        let message =
            format!("found {found} targets, expected one for each of the {expected} vertices");
        return error("targets", &message);
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

pub(super) fn write(handle: &HandleSpec) -> String {
    let mut fields = vec![field("vertices", indices::write(&handle.vertices))];
    if let Some(targets) = &handle.targets {
        fields.push(field("targets", points(targets)));
    }
    match handle.hold {
        Hold::Fixed => fields.push(field("fixed", "true".to_owned())),
        Hold::Soft { weight } if weight != HANDLE_WEIGHT => {
            fields.push(field("weight", number(weight)));
        }
        Hold::Soft { .. } => {}
    }
    object(fields)
}
