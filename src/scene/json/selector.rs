//! The forms of `on`, the selector of the vertices of a constraint.

use super::file::from_json;
use super::text::{field, object, text};
use crate::constraint::{Element, Selector};
use crate::json::{JsonError, found, indices, present, read};
use crate::scene::SceneError;
use crate::scene::error::forms_of_selectors;
use crate::scene::words::read_word;
use serde::de::{Deserialize, Deserializer, Error};
use serde_json::Value;

/// Returns the default, and least, radius of an element.
fn default_radius(element: Element) -> u32 {
    if element == Element::Ring { 1 } else { 0 }
}

impl Selector {
    /// Reads the `on` of a constraint.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(json: &str) -> Result<Selector, SceneError> {
        from_json(json)
    }
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct OfSet {
    set: String,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct OfVertices {
    #[serde(deserialize_with = "indices::deserialize")]
    vertices: Vec<u32>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct OfEach {
    each: Element,
    #[serde(default, deserialize_with = "present")]
    r#in: Option<String>,
    #[serde(default, deserialize_with = "present")]
    radius: Option<u32>,
}

impl<'de> Deserialize<'de> for Element {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Element, D::Error> {
        read_word(from, &Element::ALL.map(|element| (element.id(), element)))
    }
}

impl<'de> Deserialize<'de> for Selector {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Selector, D::Error> {
        selector_of(&Value::deserialize(from)?).map_err(D::Error::custom)
    }
}

fn selector_of(value: &Value) -> Result<Selector, JsonError> {
    if value.get("set").is_some() {
        return read(value).map(|OfSet { set }| Selector::Set(set));
    }
    if value.get("vertices").is_some() {
        let OfVertices { vertices } = read(value)?;
        if vertices.is_empty() {
            let message = "the list is empty, expected at least one vertex";
            return Err(JsonError::new("vertices", message));
        }
        return Ok(Selector::Vertices(vertices));
    }
    let (element, within, radius) = if value.is_object() {
        let OfEach { each, r#in: within, radius } = read(value)?;
        (each, within, radius)
    } else {
        let element =
            Element::ALL.into_iter().find(|e| e.word_for_all().is_some_and(|w| value == w));
        (element.ok_or_else(|| found(value, &forms_of_selectors()))?, None, None)
    };
    let least = default_radius(element);
    let radius = radius.unwrap_or(least);
    if radius < least {
        let message = format!("found {radius}, expected a whole number from {least}");
        return Err(JsonError::new("radius", message));
    }
    Ok(Selector::Each { element, within, radius })
}

/// Returns the shortest form that reads back to the selector.
pub(super) fn write(selector: &Selector) -> String {
    match selector {
        Selector::Set(name) => object(vec![field("set", text(name))]),
        Selector::Vertices(vertices) => object(vec![field("vertices", indices::write(vertices))]),
        Selector::Each { element, within, radius } => {
            let plain = within.is_none() && *radius == default_radius(*element);
            if let Some(word) = element.word_for_all().filter(|_| plain) {
                return text(word);
            }
            let mut fields = vec![field("each", text(element.id()))];
            if let Some(name) = within {
                fields.push(field("in", text(name)));
            }
            if *radius != default_radius(*element) {
                fields.push(field("radius", radius.to_string()));
            }
            object(fields)
        }
    }
}
