//! `closeness`: what vertices are kept close to, and how much.
//!
//! ```json
//! { "to": "surface", "boundary": { "corners": 45 },
//!   "weights": [ { "on": "boundary", "weight": 10 }, { "on": { "set": "skylight" }, "weight": 0 } ] }
//! ```

use super::node::JsonCursor;
use super::selector;
use super::text::{field, number, object, text};
use crate::scene::{
    BoundaryCloseness, Closeness, ClosenessTo, ClosenessWeight, NamedEnum, SceneError,
};

pub(super) fn read(at: &JsonCursor<'_>) -> Result<Closeness, SceneError> {
    at.only_keys(&["to", "weights", "boundary"])?;
    let mut closeness = Closeness::default();
    if let Some(to) = at.get("to") {
        closeness.to = to.choice()?;
    }
    if let Some(weights) = at.get("weights") {
        let entries = weights.array("an array of {\"on\": ..., \"weight\": NUMBER}")?;
        closeness.weights = entries.iter().map(read_weight).collect::<Result<_, _>>()?;
    }
    if let Some(boundary) = at.get("boundary") {
        closeness.boundary = Some(read_boundary(&boundary)?);
    }
    Ok(closeness)
}

fn read_weight(at: &JsonCursor<'_>) -> Result<ClosenessWeight, SceneError> {
    at.only_keys(&["on", "weight"])?;
    let on = selector::read(&at.need("on", &selector::what())?)?;
    let weight = at.need("weight", "a number from 0")?.number("a number from 0")?;
    Ok(ClosenessWeight { on, weight })
}

fn read_boundary(at: &JsonCursor<'_>) -> Result<BoundaryCloseness, SceneError> {
    at.only_keys(&["corners"])?;
    let mut boundary = BoundaryCloseness::default();
    if let Some(corners) = at.get("corners") {
        boundary.corners = corners.number("an angle in degrees from 0 to 180")?;
    }
    Ok(boundary)
}

/// The fields that are not the default.
pub(super) fn write(closeness: &Closeness) -> Vec<String> {
    let mut fields = Vec::new();
    if closeness.to != ClosenessTo::default() {
        fields.push(field("to", text(closeness.to.word())));
    }
    if !closeness.weights.is_empty() {
        let entry = |entry: &ClosenessWeight| {
            object(vec![
                field("on", selector::write(&entry.on)),
                field("weight", number(entry.weight)),
            ])
        };
        let entries: Vec<_> = closeness.weights.iter().map(entry).collect();
        fields.push(field("weights", format!("[{}]", entries.join(", "))));
    }
    if let Some(boundary) = closeness.boundary {
        // Also the default: it says what the corners are.
        fields.push(field("boundary", object(vec![field("corners", number(boundary.corners))])));
    }
    fields
}
