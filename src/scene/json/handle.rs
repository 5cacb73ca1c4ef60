//! One entry of the list of handles.

use super::indices;
use super::node::{JsonCursor, read_points};
use super::text::{field, number, object, points};
use crate::scene::{HANDLE_WEIGHT, HandleSpec, Hold, SceneError};

pub(super) fn read(at: &JsonCursor<'_>) -> Result<HandleSpec, SceneError> {
    at.only_keys(&["vertices", "targets", "weight", "fixed"])?;
    let list = at.need("vertices", "a list of indices")?;
    let vertices = indices::read(&list)?;
    if vertices.is_empty() {
        return Err(list.error("the list is empty, expected at least one vertex"));
    }
    let targets = match at.get("targets") {
        None => None,
        Some(targets) => {
            let points = read_points(&targets)?;
            if points.len() != vertices.len() {
                return Err(targets.error(format!(
                    "found {} targets, expected one for each of the {} vertices",
                    points.len(),
                    vertices.len()
                )));
            }
            Some(points)
        }
    };
    let fixed = at.get("fixed").map_or(Ok(false), |fixed| fixed.truth())?;
    let hold = match at.get("weight") {
        Some(weight) if fixed => {
            return Err(weight.error("a fixed handle is met exactly and takes no weight"));
        }
        Some(weight) => Hold::Soft { weight: weight.number("a number above 0")? },
        None if fixed => Hold::Fixed,
        None => Hold::Soft { weight: HANDLE_WEIGHT },
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
